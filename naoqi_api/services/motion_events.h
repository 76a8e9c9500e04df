#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "naoqi_api/memory/robot_memory.h"
#include "naoqi_api/robot_link.h"

namespace nao::services {

/// Raises in ALMemory what a robot does: each event among its device keys when its value changes
/// (robotHasFallen, BodyStiffnessChanged, bumpers ...), ALMotion/Stiffness/wakeUpStarted and its
/// like, ALMotion/MoveFailed, and once per second PostureChanged, PostureFamilyChanged and 1.x'
/// robotPoseChanged, whose value is also the key robotPose. Compares
/// what the robot published with what it had published before: but for touches, what comes and goes
/// between two deliveries is not seen. I/O thread.
class MotionEvents {
 public:
  /// Declares the events. Both outlive this, and the link delivers nothing after it.
  MotionEvents(RobotLink& link, memory::RobotMemory& memory);

  /// After the link's own delivery. Nothing happens before the robot's first cycle.
  void deliver();

  /// A walk is stopped because of an obstacle, at `place` in the robot's frame.
  void tellObstacle(const Vec3& place, bool under_way);

 private:
  void raise(const std::string& key, const rpc::Value& value);
  void raiseChanged(const std::string& key, const rpc::Value& value);
  void raiseDevices(const memory::DeviceKeys::Frames& frames);
  void raiseTasks(const motion::MotionState& state);
  void raiseMoveFailed(const motion::MotionState& state);
  void tellMoveFailed(const rpc::Value& what);
  void raisePosture(const SensorFrame& sensors);

  RobotLink& link_;
  memory::RobotMemory& memory_;
  std::vector<std::string> devices_;                    // their keys that are events
  std::map<std::string, rpc::Value> raised_;            // last values
  std::map<std::string, motion::RequestId> under_way_;  // wakeUp, rest: 0 when not
  std::uint64_t moves_failed_ = 0;
  std::optional<SimTime> posture_seen_;
};

}  // namespace nao::services
