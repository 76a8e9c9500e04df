#pragma once

#include <cstddef>

#include "core/robot_model.h"

namespace nao::validation {

/// Body `b` with all that hangs on it as one solid, every hinge beyond it held at its joint's angle
/// of `pose` [rad]: mass, centre of mass and inertia of the whole, no shapes.
Body stiffened(const RobotModel& model, std::size_t b, const JointArray<double>& pose);

}  // namespace nao::validation
