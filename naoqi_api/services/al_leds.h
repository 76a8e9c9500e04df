#pragma once

#include <memory>

#include "naoqi_api/service.h"
#include "naoqi_api/services/led_board.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// NaoQi's ALLeds: lights by name and group, fades in simulated time, seen on the robot and in
/// memory.
std::shared_ptr<rpc::Service> makeAlLeds(const ServiceContext& context,
                                         const std::shared_ptr<LedBoard>& board);

}  // namespace nao::services
