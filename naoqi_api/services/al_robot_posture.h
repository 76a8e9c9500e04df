#pragma once

#include <memory>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// ALRobotPosture: brings the robot into named postures and says in which one it is. `link` must
/// outlive the service. I/O thread.
std::shared_ptr<rpc::Service> makeAlRobotPosture(RobotLink& link);

}  // namespace nao::services
