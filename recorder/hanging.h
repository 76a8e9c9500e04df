#pragma once

#include "core/robot_model.h"
#include "validation/log/robot_log.h"

namespace nao::recorder {

/// Whether these rows are of a robot that hangs upright, as the standard motions need it: its feet
/// bear next to nothing and its torso is level. Where it has no such sensors, that is taken for
/// granted. @throws InputError with what its sensors say.
void requireHanging(const validation::LogRun& rows, const RobotModel& model);

}  // namespace nao::recorder
