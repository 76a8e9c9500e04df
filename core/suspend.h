#pragma once

#include "core/robot_model.h"

namespace nao {

/// The robot hung up by its torso, feet 1 m above the ground: a fixed base. With its own shell and
/// soles, but it cannot fall.
RobotModel suspend(const RobotModel& model);

}  // namespace nao
