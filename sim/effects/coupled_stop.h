#pragma once

#include <optional>

#include "core/robot_model.h"

namespace nao::sim {

/// The joint that a stop of `joint` would move with: the driver of its coupled limit, or without
/// one the joint whose link it hangs on. None for a joint that hangs on the root.
std::optional<Joint> findCoupledTo(const RobotModel& model, Joint joint);

}  // namespace nao::sim
