#include "camera/ground_truth.h"

#include <algorithm>
#include <map>

#include "camera/ground_painter.h"
#include "camera/renderer.h"

namespace nao::camera {

std::vector<std::string> labelNames(const SceneFrame& scene) {
  std::vector<std::string> names = {"sky", "ground", "mark"};
  const auto& obstacles = scene.world->obstacles;
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const std::string& name = obstacles[i].name;
    names.push_back(name.empty() ? "obstacle " + std::to_string(i) : name);
  }
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    const auto& balls = scene.world->balls;
    names.push_back(i < balls.size() ? balls[i].name : "ball " + std::to_string(i));
  }
  for (const SceneFrame::Robot& robot : scene.robots) names.push_back(robot.name);
  return names;
}

std::vector<LabelBox> boxesOf(const Raster& labels) {
  std::map<Pixel, LabelBox> boxes;
  for (int row = 0; row < labels.size().height; ++row) {
    const Pixel* const pixels = labels.colors(row);
    for (int column = 0; column < labels.size().width; ++column) {
      if (pixels[column] < kFirstObjectLabel) continue;
      const LabelBox fresh{pixels[column], column, row, column, row, 0};
      LabelBox& box = boxes.emplace(pixels[column], fresh).first->second;
      box.left = std::min(box.left, column);
      box.right = std::max(box.right, column + 1);
      box.bottom = row + 1;
      ++box.pixels;
    }
  }
  std::vector<LabelBox> found;
  for (const auto& [unused, box] : boxes) found.push_back(box);
  return found;
}

GroundTruth calcGroundTruth(const SceneFrame& scene, const std::optional<CameraPlace>& own,
                            const View& view, Renderer& renderer) {
  const Raster& raster = renderer.renderLabels(scene, own, view);
  const ImageSize size = view.lens.size;
  const LinearForm ground = GroundForms(view).inverseDepth();
  GroundTruth truth{size, {}, {}, boxesOf(raster)};
  for (int row = 0; row < size.height; ++row) {
    const Pixel* const labels = raster.colors(row);
    const float* const depths = raster.inverseDepths(row);
    for (int column = 0; column < size.width; ++column) {
      const bool is_thing = depths[column] > 0;
      const double on_ground = labels[column] == kSkyLabel ? 0 : ground.at(column + 0.5, row + 0.5);
      const double inverse = is_thing ? static_cast<double>(depths[column]) : on_ground;
      truth.labels.push_back(labels[column]);
      truth.depths.push_back(inverse > 0 ? static_cast<float>(1 / inverse) : 0);
    }
  }
  return truth;
}

}  // namespace nao::camera
