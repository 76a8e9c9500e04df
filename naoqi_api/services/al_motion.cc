#include "naoqi_api/services/al_motion.h"

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/al_motion_angles.h"
#include "naoqi_api/services/al_motion_cartesian.h"
#include "naoqi_api/services/al_motion_collisions.h"
#include "naoqi_api/services/al_motion_footsteps.h"
#include "naoqi_api/services/al_motion_geometry.h"
#include "naoqi_api/services/al_motion_inner.h"
#include "naoqi_api/services/al_motion_stiffness.h"
#include "naoqi_api/services/al_motion_switches.h"
#include "naoqi_api/services/al_motion_tasks.h"
#include "naoqi_api/services/al_motion_tools.h"
#include "naoqi_api/services/al_motion_touch.h"
#include "naoqi_api/services/al_motion_trajectory.h"
#include "naoqi_api/services/al_motion_walk.h"
#include "naoqi_api/services/al_motion_whole_body.h"

namespace nao::services {
namespace {

// Methods that a V5 does not list get ids after its last one, 327.
constexpr std::uint32_t kFirstFreeUid = 328;

template <class Part>
void addPart(rpc::Service& service, RobotLink& link) {
  const auto part = std::make_shared<Part>(link);
  part->declare(service);
  service.owning(part);
}

}  // namespace

std::shared_ptr<rpc::Service> makeAlMotion(RobotLink& link) {
  return makeAlMotion(
      link, {std::make_shared<ObstacleReflex>(link), std::make_shared<MotionHistory>(link)});
}

std::shared_ptr<rpc::Service> makeAlMotion(RobotLink& link, const MotionObservers& observers) {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALMotion", "Joint angles, stiffness, walking, and facts about the body."));
  service->startAt(kFirstFreeUid);
  addPart<AlMotionStiffness>(*service, link);
  addPart<AlMotionAngles>(*service, link);
  addPart<AlMotionWalk>(*service, link);
  addPart<AlMotionFootsteps>(*service, link);
  addPart<AlMotionCartesian>(*service, link);
  addPart<AlMotionWholeBody>(*service, link);
  addPart<AlMotionGeometry>(*service, link);
  addPart<AlMotionTools>(*service, link);
  addPart<AlMotionTasks>(*service, link);
  addPart<AlMotionSwitches>(*service, link);
  addPart<AlMotionCollisions>(*service, link);
  addPart<AlMotionTouch>(*service, link);
  observers.reflex->declare(*service);
  service->owning(observers.reflex);
  observers.history->declare(*service);
  service->owning(observers.history);
  addPart<AlMotionTrajectory>(*service, link);
  addPart<AlMotionInner>(*service, link);
  return service;
}

}  // namespace nao::services
