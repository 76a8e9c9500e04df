#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/robot_model.h"
#include "motion/robot_ports.h"
#include "naoqi_api/memory/device_keys.h"
#include "naoqi_api/memory/memory_store.h"

namespace nao::memory {

/// All that ALMemory knows of one robot: the store, filled with what is fixed or idle on this
/// robot, and the views of its devices. Where both have a key the view counts, as the devices of a
/// real robot write over what others put there. I/O thread only.
class RobotMemory {
 public:
  /// @param ports where the robot publishes
  /// @param name the robot's own, as its owner calls it
  /// @param clock NaoQi's: simulated time since 1970
  RobotMemory(const RobotModel& model, std::shared_ptr<const motion::RobotPorts> ports,
              const std::string& name, std::function<Duration()> clock);

  MemoryStore& store() { return store_; }
  const DeviceKeys& devices() const { return devices_; }

  /// The value and its time; keys read with the same `frames` are of one moment.
  std::optional<Stamped> read(const std::string& key, const DeviceKeys::Frames& frames) const;
  std::optional<Stamped> read(const std::string& key) const { return read(key, devices_.frames()); }

  std::optional<KeyType> typeOf(const std::string& key) const;

  /// The keys that contain `filter`, in alphabetical order.
  std::vector<std::string> names(std::string_view filter = {}) const;
  std::vector<std::string> namesOf(KeyType type) const;

 private:
  MemoryStore store_;
  DeviceKeys devices_;
};

}  // namespace nao::memory
