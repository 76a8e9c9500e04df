#pragma once

#include <string>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads an animation of NaoQi 2's editor (.qianim): ActuatorCurves of Keys as in a .xar, without
/// boxes; each curve has its own fps, and units go by name (degree, radian, dimensionless).
/// Curves in metres and joints this robot has not are left out with a warning.
/// @throws InputError with source and line if the text is no such animation.
Timeline readQianim(const std::string& text, const std::string& source, const RobotModel& model);

}  // namespace nao::motion
