#include "camera/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "camera/color_conversion.h"
#include "core/random.h"
#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

constexpr Color kBlack{0, 0, 0};
constexpr Color kWhite{255, 255, 255};
constexpr Color kRed{255, 0, 0};

SceneFrame blackScene() {
  SceneFrame scene = emptyScene();
  worldOf(scene).ground_color = kBlack;
  worldOf(scene).sky_color = kBlack;
  worldOf(scene).ground_size = {1e7, 1e7};
  return scene;
}

int redOf(Pixel pixel) { return static_cast<int>(pixel & 0xff); }

/// Pixels with more red than a white surface shows when half of the pixel is covered.
struct Blob {
  double area = 0;
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();
};

Blob redBlob(const Raster& raster) {
  Blob blob;
  for (int row = 0; row < raster.size().height; ++row) {
    for (int column = 0; column < raster.size().width; ++column) {
      if (redOf(raster.colors(row)[column]) < 90) continue;
      blob.area += 1;
      blob.centre += Eigen::Vector2d(column + 0.5, row + 0.5);
    }
  }
  blob.centre /= std::max(blob.area, 1.0);
  return blob;
}

/// The same by casting 4 x 4 rays a pixel at the sphere: slow, and another way to the truth.
Blob castSphere(const View& view, const Vec3& centre_W, double radius) {
  const Vec3 c = view.X_WC.inverse() * centre_W;
  Blob blob;
  for (int y = 0; y < view.lens.size.height * 4; ++y) {
    for (int x = 0; x < view.lens.size.width * 4; ++x) {
      const Eigen::Vector2d p((x + 0.5) / 4, (y + 0.5) / 4);
      const Vec3 d(1, (view.lens.cx - p.x()) / view.lens.fx, (view.lens.cy - p.y()) / view.lens.fy);
      if (c.cross(d).norm() / d.norm() > radius || c.dot(d) < 0) continue;
      blob.area += 1.0 / 16;
      blob.centre += p / 16;
    }
  }
  blob.centre /= blob.area;
  return blob;
}

void expectSphereWhereRaysSay(const View& view, const Vec3& centre, double radius) {
  SceneFrame scene = blackScene();
  scene.balls.push_back({radius, centre, kWhite, Mat3::Identity()});
  Renderer renderer;
  const Blob seen = redBlob(renderer.render(scene, view));
  const Blob expected = castSphere(view, centre, radius);
  ASSERT_GT(expected.area, 20);
  EXPECT_NEAR(seen.centre.x(), expected.centre.x(), 0.5);
  EXPECT_NEAR(seen.centre.y(), expected.centre.y(), 0.5);
  // Half a pixel all around the outline.
  const double outline = 2 * std::sqrt(M_PI * expected.area);
  EXPECT_NEAR(seen.area, expected.area, 0.5 * outline);
}

TEST(Renderer, ASphereOffTheAxisCoversWhatRaysSay) {
  expectSphereWhereRaysSay(viewFrom({0, 0, 1}, 0), {0.4, 0.1, 1.08}, 0.0325);
  expectSphereWhereRaysSay(viewFrom({0, 0, 0.5}, 0.6), {0.5, -0.12, 0.1}, 0.05);
  expectSphereWhereRaysSay(viewFrom({0, 0, 0.5}, 0.3, {320, 240}), {1.5, 0.2, 0.1}, 0.05);
}

TEST(Renderer, ASphereBehindTheCameraIsNotSeen) {
  SceneFrame scene = blackScene();
  scene.balls.push_back({0.0325, {-0.5, 0, 1}, kWhite, Mat3::Identity()});
  Renderer renderer;
  EXPECT_EQ(redBlob(renderer.render(scene, viewFrom({0, 0, 1}, 0))).area, 0);
}

TEST(Renderer, ASphereSunkIntoTheGroundShowsItsUpperHalf) {
  SceneFrame scene = blackScene();
  scene.balls.push_back({0.05, {0.6, 0, 0}, kWhite, Mat3::Identity()});
  Renderer renderer;
  const View view = viewFrom({0, 0, 0.1}, 0);
  const Blob seen = redBlob(renderer.render(scene, view));
  const double v_of_waterline = view.lens.cy + view.lens.fy * 0.1 / 0.55;  // nearest to the camera
  EXPECT_LT(seen.centre.y(), v_of_waterline);
  EXPECT_LT(seen.area, 0.75 * castSphere(view, {0.6, 0, 0}, 0.05).area);
  EXPECT_GT(seen.area, 0.45 * castSphere(view, {0.6, 0, 0}, 0.05).area);
}

TEST(Renderer, ARingFallsWhereThePinholeSaysFromInsideAndOutside) {
  for (const double centre : {0.0, 2.0}) {
    SceneFrame scene = blackScene();
    GroundMark ring;
    ring.kind = GroundMark::Kind::Ring;
    ring.from = ring.to = {centre, 0};
    ring.radius = 1;
    worldOf(scene).marks.push_back(ring);
    Renderer renderer;
    View view = viewFrom({0, 0, 0.5}, 0.25);
    const Raster& raster = renderer.render(scene, view);
    for (const double angle : {-0.35, -0.1, 0.0, 0.2, 0.35}) {
      const Vec3 p_W(centre + std::cos(angle), std::sin(angle), 0);
      const auto on_picture = view.lens.project(view.X_WC.inverse() * p_W);
      ASSERT_TRUE(on_picture);
      const auto column = static_cast<int>(on_picture->x());
      ASSERT_TRUE(column >= 0 && column < 640);
      EXPECT_GT(redOf(raster.colors(static_cast<int>(on_picture->y()))[column]), 250) << angle;
    }
    EXPECT_EQ(redOf(raster.colors(470)[320]), 0);  // the lower edge is inside or before the ring
  }
}

TEST(Renderer, ASolidThatReachesBehindTheCameraIsCutNotLost) {
  SceneFrame scene = blackScene();
  // A table top 10 cm below the eye, from 1 m behind to 3 m ahead, 0.5 m wide.
  worldOf(scene).obstacles = {
      {"", makeShape(Shape::Kind::Box, {4, 0.5, 0.1}, kRed, {1, 0, 0.85}), {}}};
  Renderer renderer;
  const View view = viewFrom({0, 0, 1}, 0);
  const Raster& raster = renderer.render(scene, view);
  const double far_edge = view.lens.cy + view.lens.fy * 0.1 / 3;
  for (int row = 0; row < 480; ++row) {
    const bool on_table = redOf(raster.colors(row)[320]) > 100;
    if (std::abs(row + 0.5 - far_edge) <= 1) continue;
    EXPECT_EQ(on_table, row > far_edge) << row;
  }
  const int row = 300;
  const double depth = view.lens.fy * 0.1 / (row + 0.5 - view.lens.cy);
  for (int column = 0; column < 640; ++column) {
    const double from_middle = std::abs(column + 0.5 - 320);
    const double edge = view.lens.fx * 0.25 / depth;
    const bool on_table = redOf(raster.colors(row)[column]) > 100;
    if (std::abs(from_middle - edge) <= 1) continue;
    EXPECT_EQ(on_table, from_middle < edge) << column;
  }
}

TEST(Renderer, NearThingsHideFarOnes) {
  SceneFrame scene = blackScene();
  const Shape near = makeShape(Shape::Kind::Box, {0.1, 0.1, 0.1}, kRed, {1, 0, 1});
  const Shape far = makeShape(Shape::Kind::Cylinder, {0.3, 0, 1}, {0, 0, 255}, {2, 0, 1});
  scene.balls.push_back({0.05, {1.5, 0, 1}, kWhite, Mat3::Identity()});  // between, hidden
  for (const bool near_first : {true, false}) {
    worldOf(scene).obstacles = {{"", near_first ? near : far, {}},
                                {"", near_first ? far : near, {}}};
    Renderer renderer;
    const Raster& raster = renderer.render(scene, viewFrom({0, 0, 1}, 0));
    const Pixel middle = raster.colors(240)[320];
    EXPECT_GT(redOf(middle), 100);
    EXPECT_EQ(middle >> 16, 0u);
    EXPECT_GT(raster.colors(240)[240] >> 16, 100u);  // beside the box: the cylinder
  }
}

TEST(Renderer, EverySolidCoversItsProjectedOutline) {
  // Seen end-on or side-on from 3 m; expected areas by the face that is nearest.
  Renderer renderer;
  const View view = viewFrom({0, 0, 1}, 0);
  const auto areaOf = [&](Shape::Kind kind, const Vec3& size) {
    SceneFrame scene = blackScene();
    worldOf(scene).obstacles = {{"", makeShape(kind, size, kWhite, {3, 0, 1}), {}}};
    return redBlob(renderer.render(scene, view)).area;
  };
  const double f = view.lens.fx;
  // Outline in pixels times half a pixel, plus the flats of the polygons (1 % of a 32-gon).
  EXPECT_NEAR(areaOf(Shape::Kind::Box, {0.2, 0.4, 0.3}), f * f * 0.4 * 0.3 / (2.9 * 2.9), 220);
  const double side_on = f * f / 9.0;
  EXPECT_NEAR(areaOf(Shape::Kind::Cylinder, {0.1, 0, 0.5}) / (side_on * 0.2 * 0.5), 1, 0.05);
  EXPECT_NEAR(areaOf(Shape::Kind::Capsule, {0.1, 0, 0.5}) / (side_on * (0.2 * 0.5 + M_PI * 0.01)),
              1, 0.03);
}

TEST(Renderer, PicturesDoNotDependOnTheOrderOfThingsNorOnThePictureBefore) {
  SceneFrame scene = fieldScene();
  scene.balls.push_back({0.05, {1.03, 0.1, 0.05}, {200, 30, 30}, Mat3::Identity()});
  scene.robots.push_back(simpleRobot("a", translation({2, -0.5, 0.32})));
  scene.robots.push_back(simpleRobot("b", translation({1.2, 0.5, 0.32})));
  const View view = viewFrom({-0.5, 0, 0.5}, 0.3);
  Renderer renderer;
  const Bytes first = toBytes(renderer.render(scene, view), ColorSpace::kRGB);
  renderer.render(scene, viewFrom({0.9, 0, 0.3}, 1.0, {320, 240}));
  EXPECT_TRUE(first == toBytes(renderer.render(scene, view), ColorSpace::kRGB));
  std::reverse(scene.robots.begin(), scene.robots.end());
  std::reverse(scene.balls.begin(), scene.balls.end());
  std::reverse(worldOf(scene).obstacles.begin(), worldOf(scene).obstacles.end());
  EXPECT_TRUE(first == toBytes(renderer.render(scene, view), ColorSpace::kRGB));
}

/// An eye anywhere: upright, rolled over, under the carpet, inside a robot.
View randomView(Random& random) {
  View view = viewFrom(
      Vec3(random.uniform(-4, 4), random.uniform(-3, 3), random.uniform(-0.3, 1.5)), 0, {80, 60});
  Eigen::Quaterniond q(random.normal(), random.normal(), random.normal(), random.normal());
  view.X_WC.linear() = q.normalized().toRotationMatrix();
  return view;
}

TEST(Renderer, FromAnywhereEveryPixelIsPaintedAnew) {
  SceneFrame scene = fieldScene();
  scene.robots.push_back(simpleRobot("a", translation({0.5, 0, 0.32})));
  Random random(1, "views");
  Renderer used;
  for (int i = 0; i < 300; ++i) {
    const View view = randomView(random);
    Renderer fresh;
    const Bytes expected = toBytes(fresh.render(scene, view), ColorSpace::kRGB);
    ASSERT_TRUE(expected == toBytes(used.render(scene, view), ColorSpace::kRGB)) << i;
  }
}

TEST(Renderer, AWorldThatBlewUpStillGivesAPicture) {
  for (const double lost : {std::nan(""), HUGE_VAL, 1e200, -1e7}) {
    SceneFrame scene = fieldScene();
    scene.robots.push_back(simpleRobot("a", translation({lost, 0, 0.32})));
    scene.robots.push_back(simpleRobot("b", translation({0, lost, lost})));
    scene.balls[0].p_W.x() = lost;
    Renderer renderer;
    EXPECT_TRUE(
        isColor(renderer.render(scene, {0, 0}, {80, 60}).colors(30)[40], scene.world->sky_color));
    const Raster& from_outside = renderer.render(scene, viewFrom({-2, 0, 0.5}, 0.3, {80, 60}));
    EXPECT_TRUE(isColor(from_outside.colors(59)[40], scene.world->ground_color));
  }
}

// The poses are exact fractions, so that not even a sine can differ between machines. A change of
// the picture that is meant changes this number.
TEST(Renderer, TheSamePixelsOnEveryMachine) {
  SceneFrame scene = fieldScene();
  scene.robots.push_back(simpleRobot("a", translation({2, -0.5, 0.32})));
  View view = viewFrom({-0.5, 0, 0.5}, 0);
  view.X_WC.linear() << 0.96, 0, 0.28, 0, 1, 0, -0.28, 0, 0.96;
  Renderer renderer;
  Image image;
  image.bytes =
      std::make_shared<const Bytes>(toBytes(renderer.render(scene, view), ColorSpace::kRGB));
  EXPECT_EQ(image.hash(), 1088797149224804429u);
}

TEST(Renderer, TheOwnHeadDoesNotStandInTheWay) {
  SceneFrame scene = blackScene();
  SceneFrame::Robot robot = simpleRobot("a", translation({0, 0, 1}));
  RobotModel model = *robot.model;
  model.bodies[1].visuals.push_back(
      makeShape(Shape::Kind::Box, {0.01, 0.2, 0.2}, kRed, {0.1, 0, 0}));  // a visor on the head
  robot.model = std::make_shared<const RobotModel>(model);
  scene.robots = {robot};
  Renderer renderer;
  EXPECT_EQ(redBlob(renderer.render(scene, {0, 0}, {640, 480})).area, 0);
  const View same_eye = viewOf(scene, {0, 0}, {640, 480});
  EXPECT_GT(redBlob(renderer.render(scene, same_eye)).area, 640 * 100);
}

TEST(Renderer, TheOwnFootIsSeen) {
  SceneFrame scene = blackScene();
  SceneFrame::Robot robot = simpleRobot("a", translation({0, 0, 0.3}));
  robot.X_WB[2] = translation({0.5, 0, 0.5});  // a high kick
  scene.robots = {robot};
  Renderer renderer;
  const Raster& raster = renderer.render(scene, {0, 0}, {640, 480});
  EXPECT_GT(redOf(raster.colors(240)[320]), 40);
}

}  // namespace
}  // namespace nao::camera
