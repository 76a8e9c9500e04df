#pragma once

#include <memory>

#include "naoqi_api/service.h"
#include "naoqi_api/services/led_board.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// NaoQi's DCM: timed commands straight to the actuators, one by one or by aliases. Joints and
/// their hardness go to the robot's own queues (motion/direct_queue.h), lights fade, and what is
/// left is written to memory when its time has come.
std::shared_ptr<rpc::Service> makeDcm(const ServiceContext& context,
                                      const std::shared_ptr<LedBoard>& board);

}  // namespace nao::services
