#pragma once

#include <memory>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// ALMotion: joint angles, stiffness, walking and what there is to know about the body. Method
/// ids are those seen on a V5's wire. `link` must outlive the service. I/O thread.
std::shared_ptr<rpc::Service> makeAlMotion(RobotLink& link);

}  // namespace nao::services
