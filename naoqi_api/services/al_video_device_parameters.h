#pragma once

#include <cstdint>
#include <map>

namespace nao::services {

/// What a parameter of a NaoQi camera accepts.
struct CameraParameter {
  int id = 0;
  std::int32_t min = 0;
  std::int32_t max = 0;
  std::int32_t initial = 0;
};

/// The parameter of this NaoQi number (kCameraBrightnessID 0 ... kCameraFocusID 43), or null.
/// Ranges and defaults are those of the MT9M114 of V4 and V5; a parameter without a published
/// range accepts every number.
const CameraParameter* findCameraParameter(int id);

/// The parameters of one camera as clients set them. They are remembered; the picture does not
/// follow them.
class CameraParameters {
 public:
  /// The value set last, or the default.
  std::int32_t get(const CameraParameter& parameter) const;

  /// False, and nothing changes, when the value is out of range.
  bool set(const CameraParameter& parameter, std::int32_t value);

  void reset(const CameraParameter& parameter) { values_.erase(parameter.id); }
  void resetAll() { values_.clear(); }

 private:
  std::map<int, std::int32_t> values_;
};

}  // namespace nao::services
