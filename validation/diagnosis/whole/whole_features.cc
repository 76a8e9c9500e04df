#include "validation/diagnosis/whole/whole_features.h"

#include <cmath>

#include "validation/diagnosis/replay/gait_numbers.h"

namespace nao::validation {
namespace {

constexpr double kBin = 0.02;           // [s] two cycles: a third of a Nao's gear's slowest swing
constexpr double kStretch = 0.5;        // [s] about a step of a walk: jolts of landings are gone
constexpr double kAngle = 2.5e-4;       // [rad] a sixth of an encoder's count
constexpr double kTilt = 5e-4;          // [rad]
constexpr double kAcceleration = 0.02;  // [m/s^2] its size of interest, as the next
constexpr double kTurning = 2e-3;       // [rad/s]
constexpr double kWeight = 0.5;         // [N] 1 % of a Nao
constexpr double kPlace = 5e-4;         // [m]
constexpr double kHeading = 1e-3;       // [rad]

void putBins(const Eigen::VectorXd& course, Eigen::Index per_bin, Eigen::Index bins, double*& to) {
  for (Eigen::Index b = 0; b < bins; ++b) *to++ = course.segment(b * per_bin, per_bin).mean();
}

// Column by column of x, y, yaw: what each stretch added.
void putStretches(const Eigen::MatrixXd& place, Eigen::Index per_stretch, Eigen::Index count,
                  double*& to) {
  for (Eigen::Index s = 0; s < count; ++s) {
    const Eigen::MatrixXd part = place.middleRows(s * per_stretch, per_stretch + 1);
    const Eigen::RowVectorXd moved = fromFirstRow(part).row(per_stretch);
    for (Eigen::Index i = 0; i < 3; ++i) to[i * count + s] = moved[i];
  }
  to += 3 * count;
}

}  // namespace

FeatureSpace::FeatureSpace(const WholeSimulator& simulator, const WholeBlock& block,
                           const std::vector<Joint>& joints, bool body)
    : joints_(joints), body_(body), rows_(block.rows) {
  const WholeRun& like = simulator.measured()[block.runs.front()];
  per_bin_ = std::max<Eigen::Index>(1, std::lround(kBin / like.dt));
  per_stretch_ = std::max<Eigen::Index>(1, std::lround(kStretch / like.dt));
  const double dt = static_cast<double>(per_bin_) * like.dt;
  const Eigen::Index bins = rows_ / per_bin_;
  for (const Joint joint : joints_) {
    add(simulator.model().actuators[index(joint)].name, "rad", bins, dt, kAngle);
  }
  if (!body_) return;
  if (like.tilt.size() > 0) {
    add("roll", "rad", bins, dt, kTilt);
    add("pitch", "rad", bins, dt, kTilt);
  }
  if (like.weight.size() > 0) {
    add("weight_left", "N", bins, dt, kWeight);
    add("weight_right", "N", bins, dt, kWeight);
  }
  const double long_dt = static_cast<double>(per_stretch_) * like.dt;
  const auto addMeans = [&](const std::string& name, const std::string& unit, double floor) {
    add(name, unit, rows_ / per_stretch_, long_dt, floor);
  };
  for (Eigen::Index i = 0; i < like.acceleration.cols(); ++i) {
    addMeans(std::string("acceleration_") + "xyz"[i], "m/s^2", kAcceleration);
  }
  for (Eigen::Index i = 0; i < like.turning.cols(); ++i) {
    addMeans(std::string("turning_") + "xyz"[i], "rad/s", kTurning);
  }
  if (like.place.size() > 0) {
    const Eigen::Index count = (rows_ - 1) / per_stretch_;
    add("ahead", "m", count, long_dt, kPlace);
    add("aside", "m", count, long_dt, kPlace);
    add("turn", "rad", count, long_dt, kHeading);
  }
  for (const GaitNumber& number : calcGait(like)) {
    add(number.name, number.unit, 1, 0, number.floor);
  }
}

void FeatureSpace::add(std::string name, std::string unit, Eigen::Index size, double dt,
                       double floor) {
  groups_.push_back({std::move(name), std::move(unit), size_, size, dt, floor});
  size_ += size;
}

Eigen::VectorXd FeatureSpace::of(const WholeRun& run) const {
  Eigen::VectorXd all = Eigen::VectorXd::Zero(size_);
  double* to = all.data();
  const Eigen::Index bins = rows_ / per_bin_;
  for (const Joint joint : joints_) {
    putBins(run.angle.col(static_cast<Eigen::Index>(index(joint))), per_bin_, bins, to);
  }
  if (!body_) return all;
  for (const Eigen::MatrixXd* signal : {&run.tilt, &run.weight}) {
    for (Eigen::Index i = 0; i < signal->cols(); ++i) {
      putBins(signal->col(i), per_bin_, bins, to);
    }
  }
  for (const Eigen::MatrixXd* signal : {&run.acceleration, &run.turning}) {
    for (Eigen::Index i = 0; i < signal->cols(); ++i) {
      putBins(signal->col(i), per_stretch_, rows_ / per_stretch_, to);
    }
  }
  if (run.place.size() > 0) {
    putStretches(run.place, per_stretch_, (rows_ - 1) / per_stretch_, to);
  }
  const std::vector<GaitNumber> gait = calcGait(run);
  for (const FeatureGroup& group : groups_) {
    if (group.dt > 0) continue;
    for (const GaitNumber& number : gait) {
      if (number.name == group.name) all[group.offset] = number.value;
    }
  }
  return all;
}

}  // namespace nao::validation
