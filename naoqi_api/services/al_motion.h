#pragma once

#include <memory>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/obstacle_reflex.h"

namespace nao::services {

/// ALMotion: joint angles, stiffness, walking and what there is to know about the body. Method
/// ids are those seen on a V5's wire. `link` must outlive the service. The reflex is the caller's
/// to deliver to. I/O thread.
std::shared_ptr<rpc::Service> makeAlMotion(RobotLink& link,
                                           const std::shared_ptr<ObstacleReflex>& reflex);
std::shared_ptr<rpc::Service> makeAlMotion(RobotLink& link);

}  // namespace nao::services
