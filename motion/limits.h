#pragma once

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "motion/joint_set.h"

namespace nao::motion {

/// Moves the angles of these joints into their ranges: first each joint's own, then those that
/// depend on another joint's angle, as far as the robot's file says `clip` (head pitch by head yaw,
/// ankle roll by ankle pitch).
void clipToLimits(const RobotModel& model, const JointSet& joints, JointArray<double>& angle);

}  // namespace nao::motion
