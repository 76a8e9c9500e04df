#pragma once

#include <string>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a motion of the team HULKs (.json): "initial_positions" at time 0, then "motion": parts of
/// "keyframes" with a duration [s] and positions [rad, hands 0 to 1] by body part. Conditions on
/// the robot's state between the parts are not waited for.
/// @throws InputError with source and line if the text is no such motion.
Timeline readHulks(const std::string& text, const std::string& source, const RobotModel& model);

}  // namespace nao::motion
