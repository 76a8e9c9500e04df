#pragma once

#include <array>

#include "core/frames.h"
#include "core/robot_io.h"
#include "motion/gait.h"

namespace nao::walk {

/// Parts of the largest step, each in [-1, 1]: what ALMotion.moveToward takes.
struct StepFractions {
  double x = 0;
  double y = 0;
  double theta = 0;
};

// Aldebaran's rules for steps (control-walk pages of NAOqi 1.14 and 2.1). A step is the place of
// the swinging sole in the frame of the supporting sole:
//   x = fx max_step_x (or |min_step_x| backwards),   y = +-0.1 m + fy (max_step_y - 0.1 m),
//   theta = ftheta max_step_theta,
// clipped to that box with feet never closer than 0.088 m, then to the ellipse on x and on the
// distance beyond 0.1 m, then turned back until the boxes of the feet do not meet. (The pages
// measure the ellipse from 0.088 m; that would cost 2.5 % of the published 9.52 cm/s.)

inline constexpr double kFootSeparation = 0.1;       // [m] at rest
inline constexpr double kMinFootSeparation = 0.088;  // [m]

/// +1 for the left foot, -1 for the right.
inline double sideOf(Foot foot) { return foot == Foot::Left ? 1 : -1; }
inline Foot otherFoot(Foot foot) { return foot == Foot::Left ? Foot::Right : Foot::Left; }

/// The sole of `foot` when the robot frame R is at `place` and the feet are side by side.
Pose2 soleAt(const Pose2& place, Foot foot);

/// Time from one foot's landing to the other's [s]: 0.6 at frequency 0, 0.42 at 1.
double calcStepPeriod(const motion::GaitConfig& config);

/// The step for these fractions.
Pose2 calcStep(const StepFractions& fractions, Foot swing, const motion::GaitConfig& config);

/// `step` moved to the nearest one the rules allow, in their order.
Pose2 clipStep(const Pose2& step, Foot swing, const motion::GaitConfig& config);

/// Whether the boxes ALMotion draws round the feet overlap.
bool feetCollide(const Pose2& step, Foot swing);

/// How far along the supporting sole's x and y [m] a swinging sole at `step` may still be moved to
/// catch a fall: as far as the largest gait parameters ALMotion takes, and clear of the other foot.
struct StepRoom {
  Eigen::Vector2d low = Eigen::Vector2d::Zero();
  Eigen::Vector2d high = Eigen::Vector2d::Zero();
};
StepRoom calcStepRoom(const Pose2& step, Foot swing);

/// How far R gets in a pair of steps at full fractions of these signs.
Pose2 calcPairReach(const StepFractions& signs, const motion::GaitConfig& config);

/// The fractions that give this velocity, as far as they reach.
StepFractions fractionsFor(const motion::Velocity2& velocity, const motion::GaitConfig& config);

/// The fractions that lead R to `target` (given in R) along a constant arc, as fast as allowed.
StepFractions fractionsTowards(const Pose2& target, const motion::GaitConfig& config);

}  // namespace nao::walk
