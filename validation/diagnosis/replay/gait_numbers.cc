#include "validation/diagnosis/replay/gait_numbers.h"

#include <algorithm>
#include <cmath>

namespace nao::validation {
namespace {

// Of the weight, that a foot must feel to stand and not feel to be in the air. Free choice: between
// the noise of the force sensors and the share of a foot that is being loaded.
constexpr double kStands = 0.2, kHangs = 0.05;

double sdOf(const Eigen::VectorXd& values) {
  return std::sqrt((values.array() - values.mean()).square().mean());
}

// Landings of one foot: carries after it did not.
int landings(const Eigen::VectorXd& share) {
  int count = 0;
  bool air = false;
  for (Eigen::Index k = 0; k < share.size(); ++k) {
    if (share[k] < kHangs) air = true;
    if (air && share[k] > kStands) {
      ++count;
      air = false;
    }
  }
  return count;
}

// Between crossings of the mean upwards, by those of a smoothed roll; 0 for less than two.
double periodOf(const Eigen::VectorXd& roll, double dt) {
  const double mean = roll.mean(), sd = sdOf(roll);
  double first = -1, last = -1;
  int count = 0;
  bool low = false;
  for (Eigen::Index k = 0; k < roll.size(); ++k) {
    if (roll[k] < mean - sd / 2) low = true;
    if (!low || roll[k] < mean + sd / 2) continue;
    low = false;
    last = static_cast<double>(k) * dt;
    if (first < 0) first = last;
    ++count;
  }
  return count > 1 ? (last - first) / (count - 1) : 0;
}

void addPlace(const WholeRun& run, int steps, std::vector<GaitNumber>& all) {
  if (run.place.size() == 0) return;
  const Eigen::RowVectorXd end = run.place.row(run.place.rows() - 1);
  all.push_back({"ahead_m", "m", end[0], 0.002});
  all.push_back({"aside_m", "m", end[1], 0.002});
  all.push_back({"turn_rad", "rad", end[2], 0.005});
  if (steps < 3) return;
  all.push_back({"ahead_per_step_m", "m", end[0] / steps, 0.0005});
  all.push_back({"turn_per_step_rad", "rad", end[2] / steps, 0.001});
}

int addWeight(const WholeRun& run, std::vector<GaitNumber>& all) {
  if (run.weight.size() == 0) return 0;
  const Eigen::VectorXd sum = run.weight.rowwise().sum().cwiseMax(1);
  const Eigen::VectorXd left = run.weight.col(0).cwiseQuotient(sum);
  const Eigen::VectorXd right = run.weight.col(1).cwiseQuotient(sum);
  const int steps = landings(left) + landings(right);
  const auto both = (left.array() > kHangs && right.array() > kHangs).cast<double>();
  all.push_back({"steps", "", static_cast<double>(steps), 0.5});
  all.push_back({"left_share", "", left.mean(), 0.005});
  all.push_back({"double_support", "", both.mean(), 0.01});
  return steps;
}

void addTilt(const WholeRun& run, std::vector<GaitNumber>& all) {
  if (run.tilt.size() == 0) return;
  all.push_back({"roll_sway_rad", "rad", sdOf(run.tilt.col(0)), 0.001});
  all.push_back({"pitch_sway_rad", "rad", sdOf(run.tilt.col(1)), 0.001});
  all.push_back({"sway_period_s", "s", periodOf(run.tilt.col(0), run.dt), 0.01});
  all.push_back({"fallen", "", run.fell ? 1.0 : 0.0, 0.2});
}

}  // namespace

std::vector<GaitNumber> calcGait(const WholeRun& run) {
  std::vector<GaitNumber> all;
  const int steps = addWeight(run, all);
  addPlace(run, steps, all);
  addTilt(run, all);
  return all;
}

}  // namespace nao::validation
