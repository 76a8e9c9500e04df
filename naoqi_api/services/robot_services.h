#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "camera/image_feed.h"
#include "naoqi_api/memory/robot_memory.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service_hub.h"
#include "naoqi_api/services/al_memory.h"
#include "naoqi_api/services/al_motion.h"
#include "naoqi_api/services/al_system.h"
#include "naoqi_api/services/al_text_to_speech.h"
#include "naoqi_api/services/al_video_device.h"
#include "naoqi_api/services/behavior_runner.h"
#include "naoqi_api/services/motion_events.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// What a robot's services are made with.
struct RobotServicesSetup {
  std::shared_ptr<motion::RobotPorts> ports;
  std::shared_ptr<camera::ImageFeed> images;
  std::string robot_name;
  Duration epoch{};                              // NaoQi's clock when simulated time is 0
  std::vector<std::filesystem::path> behaviors;  // folders of motions; later ones win
  ScriptLauncher scripts;                        // runs code in boxes; empty: it is not run
  std::function<void(const std::string&)> log = [](const std::string&) {};
  std::function<void(const std::string&)> warn = [](const std::string&) {};
  std::filesystem::path data_dir;  // where clients' files live; empty: they have none
  rpc::Personality personality = rpc::Personality::naoqi();  // whose shapes methods have
};

/// Every service of NaoQi that one robot has, simulated or not. I/O thread.
class RobotServices {
 public:
  /// `link` outlives it.
  RobotServices(RobotLink& link, const RobotServicesSetup& setup);

  /// Adds all services; once. The hub outlives the calls that are made of them.
  void addTo(rpc::ServiceHub& hub);

  /// After the link's own delivery.
  void deliver();

  memory::RobotMemory& memory() { return memory_; }
  AlVideoDevice& video() { return video_; }

  /// NaoQi's clock.
  Duration now() const { return epoch_ + link_.now().time_since_epoch(); }
  rpc::CallLater later();
  rpc::Alarm alarm();

 private:
  static std::shared_ptr<BehaviorLibrary> installed(const RobotServicesSetup& setup);
  BehaviorRunner::Hooks behaviorHooks(const RobotServicesSetup& setup);

  RobotLink& link_;
  Duration epoch_;
  AlVideoDevice video_;
  memory::RobotMemory memory_;
  ServiceContext context_;
  std::shared_ptr<camera::ImageFeed> images_;
  rpc::Personality personality_;
  rpc::ServiceHub* hub_ = nullptr;
  AlMemory al_memory_;
  MotionEvents motion_events_;
  MotionObservers observers_;
  AlTextToSpeech speech_;
  AlSystem system_;
  std::shared_ptr<BehaviorRunner> behaviors_;
};

}  // namespace nao::services
