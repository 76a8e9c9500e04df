#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/robot_model.h"
#include "sim/effects/catalogue.h"

namespace nao::validation {

/// One end of a joint's range, and the joint that a coupled stop there moves with (see
/// sim/effects/coupled_stop.cc).
struct JointEnd {
  Joint stopped, other;
  double angle = 0;   // [rad]
  double inward = 1;  // 1: the joint's angle grows from there on, -1: it falls
  double play = 0;    // [rad] by which its motor, that the encoder reads, may go on

  /// [rad] How far from it the stopped joint was.
  Eigen::VectorXd left(const Eigen::VectorXd& angle) const;
};

/// None if the joint hangs on no other.
std::optional<JointEnd> endOf(const RobotModel& model, Joint stopped, bool upper,
                              const sim::EffectCatalogue& catalogue);

/// A run: of the other joint the angle, of the stopped one how far it was from its end [rad].
struct StopApproach {
  Eigen::VectorXd other, left;
};

/// Where a stop begins to move [rad of the other joint] so that, at this slope [rad/rad, not 0], it
/// is just met in this run.
double touchingPlace(const StopApproach& run, double slope);

/// A joint that met such a stop went as far as it, at the turns where it met it, and nowhere
/// further: a row of slopes and places, each where it just touches the runs, motion by motion. A
/// line elsewhere meets nothing, or cuts off what was measured. First those that begin to move
/// where the other joint is at zero: a joint that met its stop at one turn only tells no more.
std::vector<std::vector<double>> touchedLines(
    const std::vector<std::vector<StopApproach>>& motions);

}  // namespace nao::validation
