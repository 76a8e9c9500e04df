#pragma once

#include <bitset>
#include <string_view>

#include "core/robot_model.h"

namespace nao::motion {

/// Some of a robot's joints.
using JointSet = std::bitset<kMaxJoints>;

/// The joints that are members of one of NaoQi's groups ("LLeg"); none if there is no such group.
JointSet jointsOfGroup(const RobotModel& model, std::string_view group);

/// Every joint of the robot.
JointSet allJoints(const RobotModel& model);

}  // namespace nao::motion
