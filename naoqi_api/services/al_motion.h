#pragma once

#include <memory>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/motion_history.h"
#include "naoqi_api/services/obstacle_reflex.h"

namespace nao::services {

/// The parts of ALMotion that look on each cycle. Whoever makes them delivers to them.
struct MotionObservers {
  std::shared_ptr<ObstacleReflex> reflex;
  std::shared_ptr<MotionHistory> history;
};

/// ALMotion: joint angles, stiffness, walking and what there is to know about the body. Method
/// ids are those seen on a V5's wire. `link` must outlive the service. I/O thread.
std::shared_ptr<rpc::Service> makeAlMotion(RobotLink& link, const MotionObservers& observers);

/// With observers that nobody delivers to.
std::shared_ptr<rpc::Service> makeAlMotion(RobotLink& link);

}  // namespace nao::services
