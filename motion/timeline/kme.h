#pragma once

#include <string>

#include "motion/timeline/timeline.h"

namespace nao::motion {

/// Reads a key-motion file of the team Kouretes: rows "play%<22 angles>%<duration>" in radians and
/// seconds, joints in the order head (2), left arm (4), left leg (6), right leg (6), right arm (4).
/// @throws InputError with source and line if a row is not so.
Timeline readKme(const std::string& text, const std::string& source, const RobotModel& model);

}  // namespace nao::motion
