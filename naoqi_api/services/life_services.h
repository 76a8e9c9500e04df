#pragma once

#include <memory>
#include <vector>

#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// What a robot does of its own accord, as state machines in a world without people:
/// ALAutonomousLife, ALAutonomousMoves, ALBasicAwareness, ALAutonomousBlinking,
/// ALBackgroundMovement, ALListeningMovement, ALSpeakingMovement, ALExpressiveListening. A robot
/// begins with its life disabled, so that nothing interferes with what clients command.
std::vector<std::shared_ptr<rpc::Service>> makeLifeServices(const ServiceContext& context);

}  // namespace nao::services
