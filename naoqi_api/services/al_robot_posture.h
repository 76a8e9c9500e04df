#pragma once

#include <filesystem>
#include <memory>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// ALRobotPosture: brings the robot into named postures and says in which one it is. `link` must
/// outlive the service. Clients' libraries of postures are below `data_dir`; empty: they keep none.
/// I/O thread.
std::shared_ptr<rpc::Service> makeAlRobotPosture(RobotLink& link,
                                                 const std::filesystem::path& data_dir = {});

}  // namespace nao::services
