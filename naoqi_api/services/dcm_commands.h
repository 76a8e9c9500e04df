#pragma once

#include <string>
#include <vector>

#include "motion/motion_request.h"
#include "naoqi_api/value.h"

namespace nao::services {

/// A command to one actuator or alias: a value for a moment of the DCM's clock.
struct DcmCommand {
  float value = 0;
  std::int32_t time = 0;  // [ms]
};

/// What a client says to DCM.set or DCM.setAlias, read.
struct DcmCommands {
  std::string name;  // of an actuator or an alias
  motion::DirectCommands::Merge merge = motion::DirectCommands::Merge::Merge;
  std::vector<std::vector<DcmCommand>> tracks;  // one for all actuators, or one each
};

/// [name, update type, [[value, time (, importance)], ...]]. @throws CallError
DcmCommands readDcmSet(const rpc::Value& commands);

/// [alias, update type, "time-separate", importance, [time, ...], [[value, ...] per actuator]] or
/// [alias, update type, "time-mixed", [[[value, time (, importance)], ...] per actuator]].
/// @throws CallError
DcmCommands readDcmSetAlias(const rpc::Value& commands);

}  // namespace nao::services
