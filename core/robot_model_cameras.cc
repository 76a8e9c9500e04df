#include <algorithm>
#include <cmath>

#include "core/camera_effects.h"
#include "core/robot_model_parts.h"

namespace nao {
namespace {

constexpr double kRadPerDeg = M_PI / 180;
constexpr Interval kFieldOfViewDeg{1, 170};  // a pinhole lens shows less than 180

void readEffects(Config& effects, CameraModel& camera) {
  for (const CameraEffectName& effect : kCameraEffects)
    camera.effects.*effect.on = effects.flag(effect.name, false);
}

void readDistortion(Config& lens, CameraModel& camera) {
  constexpr Interval kSmall{-1, 1};  // beyond, pictures fold over
  camera.distortion = {lens.number("k1", kSmall, 0), lens.number("k2", kSmall, 0),
                       lens.number("p1", kSmall, 0), lens.number("p2", kSmall, 0)};
}

CameraModel readCamera(Config& entry, const RobotModel& model) {
  CameraModel camera;
  camera.name = entry.text("name");
  camera.body = bodyAt(entry, "body", model);
  camera.X_BC = entry.pose();
  camera.hfov = entry.number("hfov_deg", kFieldOfViewDeg) * kRadPerDeg;
  camera.vfov = entry.number("vfov_deg", kFieldOfViewDeg) * kRadPerDeg;
  camera.max_width = entry.integer("max_width", 1, 8192);
  camera.max_height = entry.integer("max_height", 1, 8192);
  for (const double rate : entry.numbers("frame_rates", 0, {1, 1000})) {
    camera.frame_rates.push_back(static_cast<int>(rate));
  }
  if (camera.frame_rates.empty() ||
      !std::is_sorted(camera.frame_rates.begin(), camera.frame_rates.end())) {
    entry.reject("frame_rates", "one rate or more, rising");
  }
  camera.sensor = entry.text("sensor", "");
  camera.latency = fromSeconds(entry.number("latency_ms", {0, 1000}, 0) / 1000);
  entry.map("distortion", Config::Presence::Optional,
            [&](Config& lens) { readDistortion(lens, camera); });
  entry.map("effects", Config::Presence::Optional,
            [&](Config& effects) { readEffects(effects, camera); });
  return camera;
}

}  // namespace

void readCameras(const std::string& file, RobotModel& model) {
  Config::read(file, [&](Config& config) {
    config.list("cameras", Config::Presence::Required, [&](Config& entry) {
      const CameraModel camera = readCamera(entry, model);
      model.frames.push_back({camera.name, camera.body, camera.X_BC});
      model.cameras.push_back(camera);
    });
  });
}

}  // namespace nao
