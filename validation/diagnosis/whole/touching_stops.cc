#include "validation/diagnosis/whole/touching_stops.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sim/effects/coupled_stop.h"
#include "validation/diagnosis/joint/by_chance.h"
#include "validation/diagnosis/rig/merge_effects.h"

namespace nao::validation {
namespace {

// From flat to steep [rad/rad]: a line between two neighbours touches the same turns as one of
// them.
constexpr double kFlattest = 0.12, kSteeper = 1.35;
constexpr int kSlopes = 12;

struct Hinges {
  Joint stopped, other;
  double end = 0;     // [rad] of the stopped one's range
  double inward = 1;  // 1: its angle grows from there on, -1: it falls
  double play = 0;    // [rad] by which its motor, that the encoder reads, may go on
};

std::optional<Hinges> hingesOf(const PlacedCause& coupled, const WholeSimulator& simulator) {
  const RobotModel& model = simulator.model();
  if (coupled.joints.size() != 1) return std::nullopt;
  const Joint stopped = coupled.joints.front();
  const std::optional<Joint> other = sim::findCoupledTo(model, stopped);
  const std::vector<Joint>& measured = simulator.joints();
  if (!other || std::find(measured.begin(), measured.end(), *other) == measured.end()) {
    return std::nullopt;
  }
  const int first = model.actuators[index(stopped)].coordinates.front();
  const Coordinate& hinge = model.coordinates[static_cast<std::size_t>(first)];
  const bool upper = coupled.cause.free[0].parameter == "upper";
  const double play =
      presentDeviation(model, index(stopped), "backlash", "width", simulator.catalogue()) / 2;
  return Hinges{stopped, *other, upper ? hinge.upper : hinge.lower, upper ? -1.0 : 1.0, play};
}

double placeIn(const Hinges& hinges, const WholeRun& run, double slope) {
  const auto of = [&](Joint joint) {
    return run.angle.col(static_cast<Eigen::Index>(index(joint))).array();
  };
  const Eigen::ArrayXd left = hinges.inward * (of(hinges.stopped) - hinges.end) + hinges.play;
  return touchingPlace(of(hinges.other).matrix(), left.matrix(), slope);
}

// The median run of every motion says how far it went; no motion went beyond.
std::optional<double> outermostPlace(const Hinges& hinges, const WholeSimulator& simulator,
                                     double slope) {
  std::optional<double> outermost;
  for (const WholeBlock& block : simulator.blocks()) {
    if (block.split != Split::Fit) continue;
    std::vector<double> places;
    for (const std::size_t run : block.runs) {
      places.push_back(placeIn(hinges, simulator.measured()[run], slope));
    }
    const double place = quantile(places, 0.5);
    if (!outermost || (slope > 0 ? place > *outermost : place < *outermost)) outermost = place;
  }
  return outermost;
}

}  // namespace

double touchingPlace(const Eigen::VectorXd& other, const Eigen::VectorXd& left, double slope) {
  const Eigen::VectorXd places = other - left / slope;
  return slope > 0 ? places.maxCoeff() : places.minCoeff();
}

void startWhereTouched(PlacedCause& coupled, const WholeSimulator& simulator) {
  const std::optional<Hinges> hinges = hingesOf(coupled, simulator);
  if (!hinges) return;
  std::vector<std::vector<double>> lines;
  for (int i = 0; i < kSlopes; ++i) {
    for (const double sign : {1.0, -1.0}) {
      const double slope = sign * kFlattest * std::pow(kSteeper, i);
      if (const auto place = outermostPlace(*hinges, simulator, slope)) {
        lines.push_back({slope, *place});
      }
    }
  }
  if (!lines.empty()) coupled.cause.together = std::move(lines);
}

}  // namespace nao::validation
