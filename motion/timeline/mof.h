#pragma once

#include <string>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a special action of the team B-Human (.mof, 2016 and later): rows of degrees in the order
/// head (2), arms (6 + 6, hands 0 to 1), legs (6 + 6), then 1 to interpolate or 0 to jump, and
/// milliseconds; "-" and "*" where a joint keeps its place. Rows are played once each in the order
/// of the text: labels and transitions choose at run time. Stiffness lines are left out.
/// @throws InputError with source and line if a row is not so.
Timeline readMof(const std::string& text, const std::string& source, const RobotModel& model);

}  // namespace nao::motion
