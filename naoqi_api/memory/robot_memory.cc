#include "naoqi_api/memory/robot_memory.h"

#include <algorithm>
#include <utility>

#include "naoqi_api/memory/idle_devices.h"

namespace nao::memory {

RobotMemory::RobotMemory(const RobotModel& model, std::shared_ptr<const motion::RobotPorts> ports,
                         const std::string& name, std::function<Duration()> clock)
    : store_(std::move(clock)), devices_(model, std::move(ports)) {
  for (const auto& [key, value] : idleDevices(model)) store_.insert(key, value);
  for (const auto& [key, value] : fixedKeys(model, name)) store_.insert(key, value);
}

std::optional<Stamped> RobotMemory::read(const std::string& key,
                                         const DeviceKeys::Frames& frames) const {
  if (devices_.findView(key)) {
    auto value = devices_.find(key, frames);
    if (!value) return std::nullopt;
    return Stamped{*std::move(value), store_.now()};
  }
  const Entry* entry = store_.find(key);
  if (!entry) return std::nullopt;
  return entry->last;
}

std::optional<KeyType> RobotMemory::typeOf(const std::string& key) const {
  if (const View* view = devices_.findView(key)) return view->type;
  if (const Entry* entry = store_.find(key)) return entry->type;
  return std::nullopt;
}

std::vector<std::string> RobotMemory::names(std::string_view filter) const {
  std::vector<std::string> names;
  for (const auto& [key, entry] : store_.entries()) {
    if (key.find(filter) != std::string::npos && !devices_.findView(key)) names.push_back(key);
  }
  const auto stored = static_cast<std::ptrdiff_t>(names.size());
  for (const auto& [key, view] : devices_.views()) {
    if (key.find(filter) != std::string::npos) names.push_back(key);
  }
  std::inplace_merge(names.begin(), names.begin() + stored, names.end());
  return names;
}

std::vector<std::string> RobotMemory::namesOf(KeyType type) const {
  std::vector<std::string> of_type;
  for (std::string& name : names()) {
    if (typeOf(name) == type) of_type.push_back(std::move(name));
  }
  return of_type;
}

}  // namespace nao::memory
