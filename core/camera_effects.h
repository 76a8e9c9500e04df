#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/camera_model.h"

namespace nao {

/// One of CameraEffects, by its name in cameras.yaml.
struct CameraEffectName {
  const char* name;
  bool CameraEffects::*on;
};
inline constexpr CameraEffectName kCameraEffects[] = {
    {"response", &CameraEffects::response},
    {"noise", &CameraEffects::noise},
    {"vignetting", &CameraEffects::vignetting},
    {"distortion", &CameraEffects::distortion},
    {"motion_blur", &CameraEffects::motion_blur},
    {"rolling_shutter", &CameraEffects::rolling_shutter}};

inline std::optional<bool CameraEffects::*> findCameraEffect(std::string_view name) {
  for (const CameraEffectName& effect : kCameraEffects) {
    if (name == effect.name) return effect.on;
  }
  return std::nullopt;
}

/// All names, with commas.
inline std::string cameraEffectNames() {
  std::string names;
  for (const CameraEffectName& effect : kCameraEffects)
    names += (names.empty() ? "" : ",") + std::string(effect.name);
  return names;
}

}  // namespace nao
