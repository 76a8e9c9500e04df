#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/robot_model.h"
#include "naoqi_api/value.h"

namespace nao::memory {

using Keys = std::vector<std::pair<std::string, rpc::Value>>;

/// Keys of devices that nothing drives or reads in the simulation, with the value they have while
/// idle: the sonar's mode and the state of the chest's light (0; clients may store others),
/// diagnosis (no error). Stored once at the start; which there are depends on body and version.
Keys idleDevices(const RobotModel& model);

/// What never changes: RobotConfig/..., identities, joint limits [rad], places of the force
/// sensors [m]. `name` is the robot's.
Keys fixedKeys(const RobotModel& model, const std::string& name);

}  // namespace nao::memory
