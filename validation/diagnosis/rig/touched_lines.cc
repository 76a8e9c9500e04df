#include "validation/diagnosis/rig/touched_lines.h"

#include <algorithm>
#include <cmath>

#include "sim/effects/coupled_stop.h"
#include "validation/diagnosis/maths/block_bootstrap.h"
#include "validation/merge_effects.h"

namespace nao::validation {
namespace {

// From flat to steep [rad/rad]: a line between two neighbours touches the same turns as one of
// them.
constexpr double kFlattest = 0.12, kSteeper = 1.35;
constexpr int kSlopes = 12;
constexpr double kSteepest = 4;  // beyond the row's last

double median(const std::vector<double>& values) {
  return quantileOf(
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())),
      0.5);
}

// The median run of every motion says how far it went; no motion went beyond.
std::optional<double> outermostPlace(const std::vector<std::vector<StopApproach>>& motions,
                                     double slope) {
  std::optional<double> outermost;
  for (const std::vector<StopApproach>& runs : motions) {
    std::vector<double> places;
    for (const StopApproach& run : runs) places.push_back(touchingPlace(run, slope));
    if (places.empty()) continue;
    const double place = median(places);
    if (!outermost || (slope > 0 ? place > *outermost : place < *outermost)) outermost = place;
  }
  return outermost;
}

// Of a line that begins to move where the other joint is at zero.
double touchingSlope(const StopApproach& run, double sign) {
  double least = kSteepest;
  for (Eigen::Index i = 0; i < run.other.size(); ++i) {
    const double bent = sign * run.other[i];
    if (bent > 0) least = std::min(least, run.left[i] / bent);
  }
  return least;
}

// The flattest of the motions' medians; none where that is no stop that moves, or none that is met.
std::optional<double> flattestSlope(const std::vector<std::vector<StopApproach>>& motions,
                                    double sign) {
  double flattest = kSteepest;
  for (const std::vector<StopApproach>& runs : motions) {
    std::vector<double> slopes;
    for (const StopApproach& run : runs) slopes.push_back(touchingSlope(run, sign));
    if (!slopes.empty()) flattest = std::min(flattest, median(slopes));
  }
  if (flattest <= 0 || flattest >= kSteepest) return std::nullopt;
  return sign * flattest;
}

}  // namespace

Eigen::VectorXd JointEnd::left(const Eigen::VectorXd& of) const {
  return (inward * (of.array() - angle) + play).matrix();
}

std::optional<JointEnd> endOf(const RobotModel& model, Joint stopped, bool upper,
                              const sim::EffectCatalogue& catalogue) {
  const std::optional<Joint> other = sim::findCoupledTo(model, stopped);
  if (!other) return std::nullopt;
  const int first = model.actuators[index(stopped)].coordinates.front();
  const Coordinate& hinge = model.coordinates[static_cast<std::size_t>(first)];
  const double play = presentDeviation(model, index(stopped), "backlash", "width", catalogue) / 2;
  return JointEnd{stopped, *other, upper ? hinge.upper : hinge.lower, upper ? -1.0 : 1.0, play};
}

double touchingPlace(const StopApproach& run, double slope) {
  const Eigen::VectorXd places = run.other - run.left / slope;
  return slope > 0 ? places.maxCoeff() : places.minCoeff();
}

std::vector<std::vector<double>> touchedLines(
    const std::vector<std::vector<StopApproach>>& motions) {
  std::vector<std::vector<double>> lines;
  for (const double sign : {1.0, -1.0}) {
    if (const auto slope = flattestSlope(motions, sign)) lines.push_back({*slope, 0});
  }
  for (int i = 0; i < kSlopes; ++i) {
    for (const double sign : {1.0, -1.0}) {
      const double slope = sign * kFlattest * std::pow(kSteeper, i);
      if (const auto place = outermostPlace(motions, slope)) lines.push_back({slope, *place});
    }
  }
  return lines;
}

}  // namespace nao::validation
