#pragma once

#include <memory>

#include "naoqi_api/service.h"
#include "naoqi_api/services/behavior_runner.h"

namespace nao::services {

/// ALBehaviorManager: runs the behaviors that are installed. I/O thread.
std::shared_ptr<rpc::Service> makeAlBehaviorManager(std::shared_ptr<BehaviorRunner> runner);

}  // namespace nao::services
