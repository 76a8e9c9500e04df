#pragma once

#include "core/robot_model.h"
#include "validation/report.h"

namespace nao::validation {

/// What a robot's files say once they are read: masses, motors, limits, sensors, effects, and the
/// notes on what they left open. Figures in SI units and radians.
Report describeRobot(const RobotModel& model);

}  // namespace nao::validation
