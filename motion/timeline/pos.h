#pragma once

#include <string>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a pose file of the team rUNSWift: a line of joint codes (HY HP LSP ... DUR), then rows
/// "!" with degrees and the milliseconds to get there, rows "$" with stiffnesses (left out with a
/// warning: the motion engine keeps what is set), and text.
/// @throws InputError with source and line if a row does not fit the codes.
Timeline readPos(const std::string& text, const std::string& source, const RobotModel& model);

}  // namespace nao::motion
