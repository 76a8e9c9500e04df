#pragma once

#include <memory>

#include "naoqi_api/service.h"
#include "naoqi_api/services/behavior_runner.h"

namespace nao::services {

/// ALAnimationPlayer: plays installed motions by name or by tag. Where the robot has a choice it
/// takes the animations of a tag in turn, so that runs repeat. I/O thread.
std::shared_ptr<rpc::Service> makeAlAnimationPlayer(std::shared_ptr<BehaviorRunner> runner);

}  // namespace nao::services
