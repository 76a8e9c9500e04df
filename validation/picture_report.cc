#include "validation/picture_report.h"

#include <cinttypes>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "camera/color_conversion.h"

namespace nao::validation {
namespace {

nlohmann::json boxesOf(const camera::GroundTruth& truth, const SceneFrame& scene) {
  const auto names = camera::labelNames(scene);
  auto boxes = nlohmann::json::array();
  for (const camera::LabelBox& box : truth.boxes) {
    boxes.push_back({{"label", box.label},
                     {"name", names.at(box.label)},
                     {"left", box.left},
                     {"top", box.top},
                     {"right", box.right},
                     {"bottom", box.bottom},
                     {"pixels", box.pixels}});
  }
  return boxes;
}

nlohmann::json placeOf(const camera::View& view) {
  const Vec3 p = view.X_WC.translation();
  auto rotation = nlohmann::json::array();
  for (int i = 0; i < 3; ++i) {
    const Mat3& R = view.X_WC.linear();
    rotation.push_back({R(i, 0), R(i, 1), R(i, 2)});
  }
  const camera::Pinhole& lens = view.lens;
  return {{"position", {p.x(), p.y(), p.z()}},
          {"rotation", rotation},
          {"fx", lens.fx},
          {"fy", lens.fy},
          {"cx", lens.cx},
          {"cy", lens.cy}};
}

}  // namespace

std::string hashOf(const camera::Raster& picture) {
  camera::Image image;
  image.bytes =
      std::make_shared<const camera::Bytes>(camera::toBytes(picture, camera::ColorSpace::kRGB));
  char hash[24];
  std::snprintf(hash, sizeof hash, "%016" PRIx64, image.hash());
  return hash;
}

std::string toJson(const camera::Raster& picture, const camera::View& view,
                   const camera::GroundTruth& truth, const SceneFrame& scene) {
  const nlohmann::json report = {{"command", "render"},
                                 {"hash", hashOf(picture)},
                                 {"camera", placeOf(view)},
                                 {"boxes", boxesOf(truth, scene)}};
  return report.dump();
}

}  // namespace nao::validation
