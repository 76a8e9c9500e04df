#include "naoqi_api/services/motion_events.h"

#include <algorithm>
#include <array>

#include "motion/postures.h"
#include "naoqi_api/services/pose_names.h"

namespace nao::services {
namespace {

using rpc::Value;

// The NaoQi documentation of ALRobotPosture: about once per second.
constexpr Duration kPosturePeriod = std::chrono::seconds(1);

constexpr char kMoveFailed[] = "ALMotion/MoveFailed";
constexpr char kSafetyMoveFailed[] = "ALMotion/Safety/MoveFailed";  // other robots' name

// ALMotion's events that are no state. Those of sensors no Nao has are declared and never raised.
constexpr std::array<const char*, 13> kEvents = {
    kMoveFailed,
    kSafetyMoveFailed,
    "PostureChanged",
    "PostureFamilyChanged",
    "robotPoseChanged",  // of 1.x
    "ALMotion/Stiffness/wakeUpStarted",
    "ALMotion/Stiffness/wakeUpFinished",
    "ALMotion/Stiffness/restStarted",
    "ALMotion/Stiffness/restFinished",
    "ALMotion/Protection/DisabledDevicesChanged",
    "ALMotion/Safety/ChainVelocityClipped",
    "ALMotion/Safety/PushRecovery",
    "ALMotion/Safety/RobotPushed",
};

}  // namespace

MotionEvents::MotionEvents(RobotLink& link, memory::RobotMemory& memory)
    : link_(link), memory_(memory), under_way_{{"wakeUp", 0}, {"rest", 0}} {
  for (const char* event : kEvents) memory_.store().declareEvent(event, "ALMotion");
  for (const auto& [key, view] : memory_.devices().views()) {
    if (view.type != memory::KeyType::Event) continue;
    memory_.store().declareEvent(key);
    devices_.push_back(key);
  }
  link_.onTouch([this](const std::shared_ptr<const SensorFrame>& frame) {
    if (const auto state = memory_.devices().frames().state) raiseDevices({frame, state});
  });
}

void MotionEvents::deliver() {
  const memory::DeviceKeys::Frames frames = memory_.devices().frames();
  if (!frames.sensors || !frames.state) return;
  raiseDevices(frames);
  raiseTasks(*frames.state);
  raiseMoveFailed(*frames.state);
  raisePosture(*frames.sensors);
}

void MotionEvents::raise(const std::string& key, const Value& value) {
  memory_.store().raiseEvent(key, value);
}

// Whatever is so when the robot first publishes is no news.
void MotionEvents::raiseChanged(const std::string& key, const Value& value) {
  const auto [last, is_first] = raised_.try_emplace(key, value);
  if (is_first) return memory_.store().insert(key, value);
  if (last->second == value) return;
  last->second = value;
  raise(key, value);
}

void MotionEvents::raiseDevices(const memory::DeviceKeys::Frames& frames) {
  for (const std::string& key : devices_) {
    if (const auto value = memory_.devices().find(key, frames)) raiseChanged(key, *value);
  }
}

void MotionEvents::raiseTasks(const motion::MotionState& state) {
  for (auto& [name, id] : under_way_) {
    const auto task = std::find_if(state.tasks.begin(), state.tasks.end(),
                                   [&name = name](const auto& t) { return t.name == name; });
    const motion::RequestId now = task == state.tasks.end() ? 0 : task->id;
    if (now == id) continue;
    const std::string event = "ALMotion/Stiffness/" + name;
    if (id != 0) raise(event + "Finished", true);
    if (now != 0) raise(event + "Started", true);
    id = now;
  }
}

// [cause, 0: not begun or 1: stopped, where the obstacle is], as robots show it in public logs.
void MotionEvents::raiseMoveFailed(const motion::MotionState& state) {
  if (state.moves_failed == moves_failed_) return;
  const bool is_news = state.moves_failed > moves_failed_;  // not so when set back
  moves_failed_ = state.moves_failed;
  const int status = state.failed_under_way ? 1 : 0;
  if (!is_news) return;
  tellMoveFailed(Value::list({"Internal stop", status, Value()}));
}

void MotionEvents::tellMoveFailed(const Value& what) {
  for (const char* event : {kMoveFailed, kSafetyMoveFailed}) raise(event, what);
}

void MotionEvents::tellObstacle(const Vec3& place, bool under_way) {
  const auto coordinate = [&](int axis) { return Value(static_cast<float>(place[axis])); };
  tellMoveFailed(Value::list({"Obstacle detected", under_way ? 1 : 0,
                              Value::list({coordinate(0), coordinate(1), coordinate(2)})}));
}

void MotionEvents::raisePosture(const SensorFrame& sensors) {
  const bool is_set_back = posture_seen_ && sensors.time < *posture_seen_;
  if (posture_seen_ && !is_set_back && sensors.time < *posture_seen_ + kPosturePeriod) return;
  posture_seen_ = sensors.time;
  const Posture* posture = motion::findCurrentPosture(link_.model(), sensors);
  raiseChanged("PostureChanged", posture == nullptr ? "Unknown" : posture->name);
  const std::string family = motion::currentFamily(link_.model(), sensors);
  raiseChanged("PostureFamilyChanged", family);
  memory_.store().insert("robotPose", poseOf(family));
  raiseChanged("robotPoseChanged", poseOf(family));
}

}  // namespace nao::services
