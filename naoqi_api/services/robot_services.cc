#include "naoqi_api/services/robot_services.h"

#include <utility>

#include "naoqi_api/al_module.h"
#include "naoqi_api/documented/documented_services.h"
#include "naoqi_api/services/al_animation_player.h"
#include "naoqi_api/services/al_behavior_manager.h"
#include "naoqi_api/services/al_frame_manager.h"
#include "naoqi_api/services/al_leds.h"
#include "naoqi_api/services/al_motion.h"
#include "naoqi_api/services/al_robot_posture.h"
#include "naoqi_api/services/audio_services.h"
#include "naoqi_api/services/ball_services.h"
#include "naoqi_api/services/board_services.h"
#include "naoqi_api/services/dcm.h"
#include "naoqi_api/services/idle_extractors.h"
#include "naoqi_api/services/life_services.h"
#include "naoqi_api/services/system_services.h"
#include "naoqi_api/services/version_newer.h"
#include "naoqi_api/services/version_shapes.h"

namespace nao::services {

RobotServices::RobotServices(RobotLink& link, const RobotServicesSetup& setup)
    : link_(link),
      epoch_(setup.epoch),
      video_(link.sharedModel(), setup.images, setup.epoch),
      memory_(link.model(), setup.ports, setup.robot_name, [this] { return now(); }),
      context_{link, memory_, later(), setup.log, setup.warn, setup.data_dir, setup.robot_name},
      images_(setup.images),
      personality_(setup.personality),
      al_memory_(memory_,
                 [this](const std::string& name) {
                   return hub_ ? hub_->findRemote(name) : std::shared_ptr<rpc::RemoteObject>();
                 }),
      motion_events_(link, memory_),
      observers_{std::make_shared<ObstacleReflex>(link),
                 std::make_shared<MotionHistory>(link, setup.epoch)},
      speech_(memory_.store(), later(),
              [log = setup.log](const std::string& text) { log("says: " + text); }),
      system_(memory_.store(), setup.robot_name),
      behaviors_(std::make_shared<BehaviorRunner>(link, installed(setup), behaviorHooks(setup))) {
  video_.connect([this] { return link_.now(); }, setup.data_dir);
  if (!personality_.numbers_first_window) video_.nameFirstWindowAsAsked();
  speech_.keepFilesIn(setup.data_dir);
  memory_.store().insert("RobotConfig/Body/SoftwareRequirement", personality_.version);
  if (personality_.has_obstacle_reflex) {
    observers_.reflex->enable([this](const Vec3& place, ObstacleReflex::Walk walk) {
      motion_events_.tellObstacle(place, walk == ObstacleReflex::Walk::Ended);
    });
  }
}

rpc::CallLater RobotServices::later() {
  return
      [this](Duration delay, std::function<void()> then) { link_.after(delay, std::move(then)); };
}

rpc::Alarm RobotServices::alarm() {
  return [this](Duration delay, std::function<void()> then) -> std::function<void()> {
    const std::uint64_t timer = link_.after(delay, std::move(then));
    return [this, timer] { link_.cancelTimer(timer); };
  };
}

std::shared_ptr<BehaviorLibrary> RobotServices::installed(const RobotServicesSetup& setup) {
  auto library = std::make_shared<BehaviorLibrary>();
  for (const auto& folder : setup.behaviors) library->addFolder(folder);
  return library;
}

BehaviorRunner::Hooks RobotServices::behaviorHooks(const RobotServicesSetup& setup) {
  return {setup.warn,
          [this](const std::vector<std::string>& running) {
            memory_.store().raiseEvent("BehaviorsRun", rpc::toValue(running));
          },
          setup.scripts};
}

void RobotServices::addTo(rpc::ServiceHub& hub) {
  hub_ = &hub;
  al_memory_.setFindService([&hub](const std::string& name) { return hub.findService(name); });
  hub.add(al_memory_.describe());
  hub.add(system_.describe());
  hub.add(speech_.describe());
  hub.add(makeAlMotion(link_, observers_));
  hub.add(makeAlRobotPosture(link_, context_.data_dir));
  hub.add(makeAlFrameManager(link_, context_.warn,
                             std::make_shared<BehaviorLibrary>(behaviors_->library())));
  hub.add(makeAlBehaviorManager(behaviors_));
  hub.add(makeAlAnimationPlayer(behaviors_));
  hub.add(video_.describe());
  const auto lights = std::make_shared<LedBoard>(link_, context_.later);
  hub.add(makeAlLeds(context_, lights));
  hub.add(makeDcm(context_, lights));
  for (const auto& service : makeBoardServices(context_)) hub.add(service);
  for (const auto& service : makeLifeServices(context_)) hub.add(service);
  const Say say = [this](const std::string& text) { return speech_.say(text); };
  for (const auto& service : makeAudioServices(context_, say)) hub.add(service);
  for (const auto& service : makeBallServices(context_, images_)) hub.add(service);
  for (const auto& service : makeIdleExtractors(context_)) hub.add(service);
  for (const auto& service : makeSystemServices(context_, behaviors_, hub)) hub.add(service);
  addDocumented(hub);
  if (personality_.hides_newer) removeNewer(hub, personality_.release);
  for (const auto& [id, entry] : hub.entries()) {
    if (entry.service) rpc::addShortWait(*entry.service);
  }
  applyVersion(hub, personality_);
  observers_.reflex->guard(*hub.findService("ALMotion"));
}

void RobotServices::deliver() {
  motion_events_.deliver();
  observers_.reflex->deliver();
  observers_.history->deliver();
  al_memory_.deliver();
  video_.deliverImages();
}

}  // namespace nao::services
