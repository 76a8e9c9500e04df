#include "camera/eye.h"

#include "camera/lens_dirt.h"

namespace nao::camera {

Eye::Eye(const RobotModel& robot, std::size_t camera, std::uint64_t seed)
    : model_(robot.cameras.at(camera)),
      type_(sensorOf(robot, model_)),
      sensor_(type_, model_.effects, seed),
      warp_(model_.effects.distortion ? model_.distortion : LensDistortion{}) {}

void Eye::use(const CameraEffects& effects) {
  if (effects.distortion != model_.effects.distortion)
    warp_ = Warp(effects.distortion ? model_.distortion : LensDistortion{});
  model_.effects = effects;
  sensor_.use(effects);
}

Turning Eye::turningOf(const SceneFrame& scene, CameraPlace place, const View& view) const {
  const SceneFrame::Robot& robot = scene.robots[place.robot];
  const auto body = static_cast<std::size_t>(model_.body);
  Turning turning;
  const bool moves = model_.effects.rolling_shutter || model_.effects.motion_blur;
  if (!moves || body >= robot.w_WB.size()) return turning;
  turning.w_WC_C = view.X_WC.linear().transpose() * robot.w_WB[body];
  if (model_.effects.rolling_shutter) turning.readout = type_.readout;
  // Before the first picture nobody has measured the light: as in a usual hall.
  const double exposure = sensor_.exposure() > 0 ? sensor_.exposure() : type_.neutral_exposure;
  if (model_.effects.motion_blur) turning.exposure = exposure;
  return turning;
}

Raster& Eye::look(const SceneFrame& scene, CameraPlace place, ImageSize size,
                  const CameraSettings& settings, Renderer& renderer) {
  const View view = viewOf(scene, place, size);
  const Turning turning = turningOf(scene, place, view);
  const bool is_turning = !turning.w_WC_C.isZero() && (turning.readout > 0 || turning.exposure > 0);
  Raster* picture = nullptr;
  if (model_.effects.distortion || is_turning) {
    const View wide = warp_.wideView(view, turning);
    picture = &warp_.warped(renderer.render(scene, place, wide), view, wide, turning);
  } else {
    picture = &renderer.render(scene, place, view);
  }
  const auto& dirt = scene.robots[place.robot].lens_dirt;
  if (place.camera < dirt.size()) layDirt(*picture, dirt[place.camera]);
  sensor_.expose(*picture, settings, scene.world->light, scene.time);
  return *picture;
}

}  // namespace nao::camera
