// What makes a scene look like a field: textures, patches, shadows, lights, shirts, grain.

#include <gtest/gtest.h>

#include <cmath>

#include "core/leds.h"
#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

int channel(Pixel pixel, int c) { return static_cast<int>(pixel >> (8 * c) & 0xff); }

double meanOf(const Raster& raster, int c, int left, int top, int right, int bottom) {
  double sum = 0;
  for (int row = top; row < bottom; ++row) {
    for (int column = left; column < right; ++column) sum += channel(raster.colors(row)[column], c);
  }
  return sum / ((right - left) * (bottom - top));
}

std::shared_ptr<const Texture> chequer(int side) {
  std::vector<std::uint32_t> pixels;
  for (int i = 0; i < side * side; ++i)
    pixels.push_back((i % side + i / side) % 2 == 0 ? 0xffffff : 0);
  return std::make_shared<const Texture>(makeTexture(side, side, pixels));
}

/// A textured box whose near face fills the view from x = 0 at 1 m.
SceneFrame wallScene(std::shared_ptr<const Texture> texture, double turn = 0) {
  SceneFrame scene = emptyScene();
  Shape wall = makeShape(Shape::Kind::Box, {0.2, 4, 4}, {0, 0, 255}, {1.1, 0, 3});
  wall.X_BS.linear() = rotationFromRpy(0, 0, turn);
  wall.texture = std::move(texture);
  worldOf(scene).obstacles.push_back({"wall", wall, {}});
  return scene;
}

// u of the picture grows to the viewer's right, v down: the upper left quarter is white.
TEST(Looks, ATextureStandsUprightOnABox) {
  const auto texture = std::make_shared<const Texture>(makeTexture(2, 2, {0xffffff, 0, 0, 0}));
  Renderer renderer;
  const Raster& raster = renderer.render(wallScene(texture), viewFrom({-3.5, 0, 3}, 0, {64, 48}));
  EXPECT_GT(channel(raster.colors(4)[4], 0), 100);
  EXPECT_LT(channel(raster.colors(4)[60], 0), 100);
  EXPECT_LT(channel(raster.colors(44)[4], 0), 100);
}

// Perspective: on a wall turned away the texture's middle line is where its point projects, not
// half way between the wall's edges on the picture.
TEST(Looks, TexturesAreTrueToPerspective) {
  std::vector<std::uint32_t> pixels(256);
  for (std::size_t i = 128; i < 256; ++i) pixels[i] = 0xffffff;  // white from the middle on
  const auto texture = std::make_shared<const Texture>(makeTexture(256, 1, pixels));
  for (const double turn : {0.0, 0.6, -0.9}) {
    const SceneFrame scene = wallScene(texture, turn);
    const View view = viewFrom({-2, 0, 3}, 0);
    Renderer renderer;
    const Raster& raster = renderer.render(scene, view);
    const Pose& X_WS = scene.world->obstacles[0].shape.X_BS;
    const auto middle = view.lens.project(view.X_WC.inverse() * (X_WS * Vec3(-0.1, 0, 0)));
    // From the face's left edge on, as the box shows another face when turned.
    const auto edge = view.lens.project(view.X_WC.inverse() * (X_WS * Vec3(-0.1, 2, 0)));
    int column = std::max(0, static_cast<int>(edge->x()) + 3);
    while (column < 639 && channel(raster.colors(240)[column], 0) < 80) ++column;
    EXPECT_NEAR(column, middle->x(), 3) << turn;  // a texel is 8 pixels wide, mixed over it
  }
}

// A chequer finer than the picture's pixels is grey, everywhere alike, instead of flickering.
TEST(Looks, FarTexturesAreTheirMean) {
  Renderer renderer;
  const Raster& raster = renderer.render(wallScene(chequer(1024)), viewFrom({-9, 0, 3}, 0));
  for (int row = 200; row < 280; ++row) {
    for (int column = 280; column < 360; ++column) {
      const int red = channel(raster.colors(row)[column], 0);
      ASSERT_GT(red, 60);
      ASSERT_LT(red, 140);
    }
  }
}

/// Twelve columns and six rows, each of a brightness of its own.
std::shared_ptr<const Texture> chart() {
  std::vector<std::uint32_t> pixels;
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 12; ++column)
      pixels.push_back(static_cast<std::uint32_t>(20 * column | (40 * row) << 8));
  }
  return std::make_shared<const Texture>(makeTexture(12, 6, pixels));
}

/// Whether the texture's column and row are seen at a point of a shape. Light takes up to a fifth.
void expectChartAt(const View& view, const Raster& raster, const Vec3& p_W, double right,
                   double down) {
  const auto spot = view.lens.project(view.X_WC.inverse() * p_W);
  ASSERT_TRUE(spot);
  const Pixel pixel = raster.colors(static_cast<int>(spot->y()))[static_cast<int>(spot->x())];
  const int red = 20 * static_cast<int>(12 * right), green = 40 * static_cast<int>(6 * down);
  EXPECT_LE(channel(pixel, 0), red) << right << " " << down;
  EXPECT_GE(channel(pixel, 0), 0.78 * red - 1) << right << " " << down;
  EXPECT_LE(channel(pixel, 1), green) << right << " " << down;
  EXPECT_GE(channel(pixel, 1), 0.78 * green - 1) << right << " " << down;
}

// In the middles of the chart's fields as a robot sees them that looks along x.
TEST(Looks, ATextureGoesAroundACylinder) {
  SceneFrame scene = emptyScene();
  Shape post = makeShape(Shape::Kind::Cylinder, {0.3, 0, 1.2}, {0, 0, 255}, {1, 0, 1});
  post.texture = chart();
  worldOf(scene).obstacles.push_back({"post", post, {}});
  const View view = viewFrom({-0.5, 0, 1}, 0);
  Renderer renderer;
  const Raster& raster = renderer.render(scene, view);
  for (int column = 4; column < 8; ++column) {
    for (int row = 1; row < 5; ++row) {
      const double right = (column + 0.5) / 12, down = (row + 0.5) / 6;
      const double angle = 2 * M_PI * right;
      // A polygon of 32 corners is up to 0.5 % inside the circle.
      const Vec3 p_S(0.2985 * std::cos(angle), 0.2985 * std::sin(angle), 0.6 - 1.2 * down);
      expectChartAt(view, raster, Vec3(1, 0, 1) + p_S, right, down);
    }
  }
}

TEST(Looks, ATextureGoesAroundASphereAsAGlobesMap) {
  SceneFrame scene = emptyScene();
  Shape globe = makeShape(Shape::Kind::Sphere, {0.4, 0, 0}, {0, 0, 255}, {1, 0, 1});
  globe.X_BS.linear() = rotationFromRpy(0, 0.3, 1);
  globe.texture = chart();
  worldOf(scene).obstacles.push_back({"globe", globe, {}});
  const View view = viewFrom({-0.5, 0, 1}, 0);
  Renderer renderer;
  const Raster& raster = renderer.render(scene, view);
  int seen = 0;
  for (int column = 0; column < 12; ++column) {
    for (int row = 0; row < 6; ++row) {
      const double right = (column + 0.5) / 12, down = (row + 0.5) / 6;
      const double across = 0.4 * std::sin(M_PI * down), angle = 2 * M_PI * right;
      const Vec3 p_S(across * std::cos(angle), across * std::sin(angle),
                     0.4 * std::cos(M_PI * down));
      const Vec3 p_W = globe.X_BS * p_S;
      if (p_W.x() > 0.8) continue;  // on the other side, or near the rim
      ++seen;
      expectChartAt(view, raster, p_W, right, down);
    }
  }
  EXPECT_GT(seen, 10);
}

TEST(Looks, ASoccerBallHasTwelvePatchesThatTurnWithIt) {
  SceneFrame scene = emptyScene();
  SceneFrame::Ball ball{0.05, {1, 0, 1}, {235, 235, 235}, Mat3::Identity(), true};
  int dark = 0, all = 0;
  for (int i = 0; i < 20; ++i) {
    ball.R_W = rotationFromRpy(0.7 * i, 0.4 * i, 1.1 * i);
    scene.balls = {ball};
    Renderer renderer;
    const View view = viewFrom({0.6, 0, 1}, 0);
    const Raster& raster = renderer.render(scene, view);
    const double radius = 0.8 * view.lens.fx * 0.05 / 0.4;
    for (int row = 0; row < 480; ++row) {
      for (int column = 0; column < 640; ++column) {
        if (std::hypot(column - 320, row - 240) > radius) continue;
        ++all;
        dark += channel(raster.colors(row)[column], 0) < 60 ? 1 : 0;
      }
    }
  }
  // 12 caps of cosine 0.9528: 6 (1 - 0.9528) = 28 % of a sphere; 20 poses see different ones.
  EXPECT_NEAR(static_cast<double>(dark) / all, 0.283, 0.04);
}

TEST(Looks, ABallOnTheGroundHasAShadowAndOneInTheAirHasNone) {
  Renderer renderer;
  const View view = viewFrom({0, 0, 0.5}, 0.5);
  SceneFrame scene = emptyScene();
  worldOf(scene).ground_color = {200, 200, 200};
  const auto greenBeside = [&](double height) {
    scene.balls = {{0.05, {1, 0, height}, {255, 0, 0}, Mat3::Identity()}};
    const auto beside = view.lens.project(view.X_WC.inverse() * Vec3(1, 0.056, 0));
    const Raster& raster = renderer.render(scene, view);
    return channel(raster.colors(static_cast<int>(beside->y()))[static_cast<int>(beside->x())], 1);
  };
  EXPECT_LT(greenBeside(0.05), 185);
  EXPECT_EQ(greenBeside(0.5), 200);
}

TEST(Looks, GrainStraysAboutTheCarpetsColorAndFadesAfar) {
  SceneFrame scene = emptyScene();
  worldOf(scene).ground_color = {40, 120, 60};
  worldOf(scene).ground_grain = 0.3;
  Renderer renderer;
  const Raster& raster = renderer.render(scene, viewFrom({0, 0, 0.5}, 0.4));
  EXPECT_NEAR(meanOf(raster, 1, 0, 400, 640, 480), 120, 2);
  const auto spread = [&](int top) {
    double sum = 0;
    for (int column = 0; column < 640; ++column)
      sum += std::abs(channel(raster.colors(top)[column], 1) - 120);
    return sum / 640;
  };
  EXPECT_GT(spread(460), 6);
  EXPECT_LT(spread(100), 0.5 * spread(460));  // 3 m away a pixel is the mean of several cells
}

SceneFrame::Robot robotWithLights() {
  SceneFrame::Robot robot = simpleRobot("a", translation({1, 0, 0.5}));
  RobotModel model = *robot.model;
  model.bodies[0].name = "Torso";
  model.bodies[1].name = "HeadPitch";
  model.feet.resize(2);
  model.version = "V5.0";
  robot.model = std::make_shared<const RobotModel>(model);
  for (Pose& X_WB : robot.X_WB) X_WB.linear() = rotationFromRpy(0, 0, 3.14159265);
  return robot;
}

TEST(Looks, LightsThatAreOnShine) {
  SceneFrame scene = emptyScene();
  SceneFrame::Robot robot = robotWithLights();
  const auto names = ledNames(*robot.model);
  const View view = viewFrom({0.4, 0, 0.56}, 0);
  const auto greenest = [&] {
    scene.robots = {robot};
    Renderer renderer;
    const Raster& raster = renderer.render(scene, view);
    int most = 0;
    for (int row = 0; row < 480; ++row) {
      for (int column = 0; column < 640; ++column) {
        const Pixel p = raster.colors(row)[column];
        most = std::max(most, channel(p, 1) - channel(p, 0));
      }
    }
    return most;
  };
  const int dark = greenest();
  for (const std::size_t led : findLeds(names, "ChestBoard/Led/Green")) robot.leds[led] = 1;
  EXPECT_GE(greenest(), 250);  // full green, whatever light falls on it
  EXPECT_LT(dark, 100);
}

TEST(Looks, AShirtHasItsTeamsColor) {
  SceneFrame scene = emptyScene();
  scene.robots = {simpleRobot("a", translation({1, 0, 0.5}))};
  scene.robots[0].team = Color{220, 30, 30};
  Renderer renderer;
  const Pixel shirt = renderer.render(scene, viewFrom({0, 0, 0.5}, 0)).colors(240)[320];
  EXPECT_GT(channel(shirt, 0), 4 * channel(shirt, 2));
}

}  // namespace
}  // namespace nao::camera
