#include "camera/ground_truth.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

TEST(GroundTruth, LabelsAndBoxesOfWhatIsThere) {
  SceneFrame scene = emptyScene();
  worldOf(scene).obstacles.push_back(
      {"post", makeShape(Shape::Kind::Cylinder, {0.05, 0, 0.8}, {}, {3, 1, 0.4}), {}});
  addLine(worldOf(scene), 2, -2, 2, 2);
  scene.balls.push_back({0.05, {1.5, -0.2, 0.05}, {}, Mat3::Identity()});
  scene.robots.push_back(simpleRobot("other", translation({4, -1, 0.32})));
  const View view = viewFrom({0, 0, 0.5}, 0.1);
  Renderer renderer;
  const GroundTruth truth = calcGroundTruth(scene, std::nullopt, view, renderer);
  const auto names = labelNames(scene);
  EXPECT_EQ(names, (std::vector<std::string>{"sky", "ground", "mark", "post", "ball 0", "other"}));
  const auto labelAt = [&](const Vec3& p_W) {
    const auto spot = view.lens.project(view.X_WC.inverse() * p_W);
    return names[truth.labels[static_cast<std::size_t>(spot->y()) * 640 +
                              static_cast<std::size_t>(spot->x())]];
  };
  EXPECT_EQ(labelAt({1.5, -0.2, 0.05}), "ball 0");
  EXPECT_EQ(labelAt({3, 1, 0.5}), "post");
  EXPECT_EQ(labelAt({2, 0.1, 0}), "mark");
  EXPECT_EQ(labelAt({1.4, 0.2, 0}), "ground");
  EXPECT_EQ(labelAt({9, 0.1, 2}), "sky");
  ASSERT_EQ(truth.boxes.size(), 3u);
  const LabelBox& ball = truth.boxes[1];
  const auto middle = view.lens.project(view.X_WC.inverse() * Vec3(1.5, -0.2, 0.05));
  const double radius = view.lens.fx * 0.05 / 1.537;  // so far along the line of sight
  EXPECT_NEAR((ball.left + ball.right) / 2.0, middle->x(), 1);
  EXPECT_NEAR(ball.right - ball.left, 2 * radius, 2);
  // Off the axis a ball is an ellipse, here 4 % larger than the circle.
  EXPECT_NEAR(ball.pixels, M_PI * radius * radius, 0.06 * ball.pixels);
}

TEST(GroundTruth, DepthIsAlongTheLineOfSight) {
  SceneFrame scene = emptyScene();
  worldOf(scene).obstacles.push_back(
      {"wall", makeShape(Shape::Kind::Box, {0.2, 4, 0.5}, {}, {2.1, 0, 1.2}), {}});
  const View view = viewFrom({0, 0, 1}, 0);
  Renderer renderer;
  const GroundTruth truth = calcGroundTruth(scene, std::nullopt, view, renderer);
  // A wall across the view is equally deep everywhere; single precision.
  EXPECT_NEAR(truth.depths[240 * 640 + 20], 2.0, 1e-4);
  EXPECT_NEAR(truth.depths[240 * 640 + 600], 2.0, 1e-4);
  // The ground at row 470: 1 m below, (470.5 - 240) / fy down.
  EXPECT_NEAR(truth.depths[470 * 640 + 320], view.lens.fy / 230.5, 1e-3);
  EXPECT_EQ(truth.depths[5 * 640 + 320], 0);
}

}  // namespace
}  // namespace nao::camera
