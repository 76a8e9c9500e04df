#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "motion/motion_state.h"
#include "motion/robot_ports.h"
#include "naoqi_api/memory/memory_store.h"
#include "naoqi_api/value.h"

namespace nao::memory {

/// One key that shows what the robot measures or commands: a function of the newest frames.
struct View {
  KeyType type = KeyType::Data;  // Event: what an event of this name would have been raised with
  std::function<rpc::Value(const SensorFrame&, const motion::MotionState&)> read;
};

/// The keys of a robot's devices: Device/SubDeviceList/..., Motion/... and the like. Lazy views:
/// reading makes the value, nothing is written per cycle. services::MotionEvents raises those that
/// are events. Immutable; any thread.
class DeviceKeys {
 public:
  /// `ports`: where the robot publishes.
  DeviceKeys(const RobotModel& model, std::shared_ptr<const motion::RobotPorts> ports);

  /// What the robot last published: several keys read from one are of one moment. Null before the
  /// first cycle.
  struct Frames {
    std::shared_ptr<const SensorFrame> sensors;
    std::shared_ptr<const motion::MotionState> state;
  };
  Frames frames() const { return {ports_->sensors.get(), ports_->state.get()}; }

  /// Nothing if the robot has no such device, or has not published yet.
  std::optional<rpc::Value> find(const std::string& key, const Frames& frames) const;
  std::optional<rpc::Value> find(const std::string& key) const { return find(key, frames()); }

  /// Null if the robot has no such device.
  const View* findView(const std::string& key) const;
  const std::map<std::string, View>& views() const { return views_; }

 private:
  std::map<std::string, View> views_;
  std::shared_ptr<const motion::RobotPorts> ports_;
};

}  // namespace nao::memory
