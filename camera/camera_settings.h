#pragma once

#include <cstdint>
#include <map>

#include "camera/sensor_type.h"

namespace nao::camera {

/// The parameters of one camera as clients set them, by NaoQi's numbers. A plain value.
class CameraSettings {
 public:
  /// The value set last, or the default.
  std::int32_t get(const ParameterRange& parameter) const {
    const auto found = values_.find(parameter.id);
    return found == values_.end() ? parameter.initial : found->second;
  }
  std::int32_t get(const SensorType& sensor, Parameter parameter) const {
    return get(*findParameter(sensor, static_cast<int>(parameter)));
  }

  /// False, and nothing changes, when the value is out of range.
  bool set(const ParameterRange& parameter, std::int32_t value) {
    if (value < parameter.min || value > parameter.max) return false;
    values_[parameter.id] = value;
    return true;
  }

  void reset(const ParameterRange& parameter) { values_.erase(parameter.id); }
  void resetAll() { values_.clear(); }

 private:
  std::map<int, std::int32_t> values_;
};

}  // namespace nao::camera
