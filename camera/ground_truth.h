#pragma once

#include <optional>
#include <string>
#include <vector>

#include "camera/raster.h"
#include "camera/view.h"
#include "core/scene_frame.h"

namespace nao::camera {

class Renderer;
struct CameraPlace;

/// What a pixel shows, as a number in place of its colour.
inline constexpr Pixel kSkyLabel = 0;
inline constexpr Pixel kGroundLabel = 1;
inline constexpr Pixel kMarkLabel = 2;  // paint on the ground
inline constexpr Pixel kFirstObjectLabel = 3;

/// The labels of a scene's things: obstacles, then balls, then robots, in the scene's order.
class Labels {
 public:
  explicit Labels(const SceneFrame& scene)
      : first_ball_(kFirstObjectLabel + static_cast<Pixel>(scene.world->obstacles.size())),
        first_robot_(first_ball_ + static_cast<Pixel>(scene.balls.size())) {}

  Pixel ofObstacle(std::size_t i) const { return kFirstObjectLabel + static_cast<Pixel>(i); }
  Pixel ofBall(std::size_t i) const { return first_ball_ + static_cast<Pixel>(i); }
  Pixel ofRobot(std::size_t i) const { return first_robot_ + static_cast<Pixel>(i); }

 private:
  Pixel first_ball_;
  Pixel first_robot_;
};

/// The name of each label: "sky", "ground", "mark", then obstacles ("obstacle 3" without a name of
/// their own), balls and robots.
std::vector<std::string> labelNames(const SceneFrame& scene);

/// The pixels from `left`, `top` up to, not with, `right`, `bottom` that hold a thing's label.
struct LabelBox {
  Pixel label = 0;
  int left = 0, top = 0, right = 0, bottom = 0;  // [px]
  int pixels = 0;
};

/// Of every thing in a picture of labels, by ascending label; none of sky, ground and marks.
std::vector<LabelBox> boxesOf(const Raster& labels);

/// The truth about one picture.
struct GroundTruth {
  ImageSize size;
  std::vector<Pixel> labels;  // by pixel, rows from the top
  std::vector<float> depths;  // [m] along the line of sight; 0: sky
  std::vector<LabelBox> boxes;
};

/// What is seen from here; by a camera of the scene if there is an `own` one.
GroundTruth calcGroundTruth(const SceneFrame& scene, const std::optional<CameraPlace>& own,
                            const View& view, Renderer& renderer);

}  // namespace nao::camera
