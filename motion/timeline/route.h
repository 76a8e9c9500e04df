#pragma once

#include <string>

#include "core/robot_model.h"
#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a way through the robot's own posture graph (ways.yaml) as a motion, so that what the
/// graph knows can be played, linted and installed like any other. Played blindly, as every
/// motion is: it waits for nothing and does not try again. One word and its value a line:
///
///   # comment
///   from LyingBack     the family of postures in which the robot is
///   to Stand           the posture at the end
///   rest 1.0           [s] after every way; 1 if left out
///   within 2.0         [s] from the end of the last way to the posture; 2 if left out
///
/// @throws InputError with source and line if the text is not so, or if this robot has no such
/// posture or no way there.
Timeline readRoute(const std::string& text, const std::string& source, const RobotModel& model);

}  // namespace nao::motion
