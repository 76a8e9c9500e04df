#pragma once

#include <string>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a Webots motion: "#WEBOTS_MOTION,V1.0,<joints>", then rows "MM:SS:mmm,<pose>,<values>" in
/// radians, "*" where a joint is not told. Straight lines between the rows. Webots gives a hand
/// eight finger joints, 0 closed to 1 open; the first stands for the hand. A row with too few or
/// too many values is played as far as it goes, with a warning.
/// @throws InputError with source and line if the text is no such motion.
Timeline readWebotsMotion(const std::string& text, const std::string& source,
                          const RobotModel& model);

}  // namespace nao::motion
