#pragma once

#include "camera/renderer.h"
#include "camera/sensor.h"
#include "camera/warp.h"

namespace nao::camera {

/// One camera of one robot: its lens, its shutter and its sensor, each as far as its effects are
/// on. Keeps what goes on from picture to picture, such as automatic exposure.
class Eye {
 public:
  Eye(const RobotModel& robot, std::size_t camera, std::uint64_t seed);

  /// What this camera gives of the scene. Good until the next call of either.
  Raster& look(const SceneFrame& scene, CameraPlace place, ImageSize size,
               const CameraSettings& settings, Renderer& renderer);

  /// Other effects from now on.
  void use(const CameraEffects& effects);

  const Sensor& sensor() const { return sensor_; }

  /// From now on as one that has come as far as that.
  void restore(const Adaptation& state) { sensor_.restore(state); }

 private:
  Turning turningOf(const SceneFrame& scene, CameraPlace place, const View& view) const;

  CameraModel model_;
  const SensorType& type_;
  Sensor sensor_;
  Warp warp_;
};

}  // namespace nao::camera
