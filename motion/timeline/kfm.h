#pragma once

#include <string>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a key-frame motion of the Nao Devils (.kfm): keyFrames of headAngles (2), armsAngles
/// (6 + 6) and legsAngles (6 + 6), radians or with "deg" behind; 20000 where a joint keeps its
/// place; duration in milliseconds; intType linear, or sine: level at both ends. Stiffness,
/// stabilisation and what follows another motion are left out.
/// @throws InputError with source and line if a key frame is not so.
Timeline readKfm(const std::string& text, const std::string& source, const RobotModel& model);

}  // namespace nao::motion
