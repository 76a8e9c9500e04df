// Where solids cut into each other or into the ground, pixels show both by the part they cover.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

constexpr Color kBlack{0, 0, 0};
constexpr Color kWhite{255, 255, 255};

SceneFrame darkScene() {
  SceneFrame scene = emptyScene();
  worldOf(scene).ground_color = worldOf(scene).sky_color = kBlack;
  worldOf(scene).ground_size = {1e7, 1e7};
  return scene;
}

/// A wall of 4 m whose face towards the eye goes through (1, 0, 1), turned so.
Shape wall(Color color, double roll, double yaw) {
  Shape box = makeShape(Shape::Kind::Box, {0.1, 4, 4}, color);
  Pose X_WS = translation({1, 0, 1});
  X_WS.linear() = rotationFromRpy(roll, 0, 0) * rotationFromRpy(0, 0, yaw);
  box.X_BS = X_WS * translation({0.05, 0, 0});
  return box;
}

/// Where the ray through a place of the picture meets the face of a wall [m along the line of
/// sight].
double depthOf(const Shape& wall, const View& view, double u, double v) {
  const Vec3 ray = view.X_WC.linear() *
                   Vec3(1, (view.lens.cx - u) / view.lens.fx, (view.lens.cy - v) / view.lens.fy);
  const Vec3 normal = wall.X_BS.linear().col(0);
  const Vec3 on_face = wall.X_BS.translation() - 0.05 * normal;
  return normal.dot(on_face - view.X_WC.translation()) / normal.dot(ray);
}

/// Whether a place of the picture is white.
using Truth = std::function<bool(double u, double v)>;

// The border within a pixel is drawn as the straight line through it that it is, so a pixel differs
// from its true cover by what a line cut square at distance 0.5 differs from one at a slant.
void expectCover(const SceneFrame& scene, const View& view, const Truth& is_white) {
  Renderer renderer;
  const Raster& raster = renderer.render(scene, view);
  const ImageSize size = view.lens.size;
  int brightest = 0;
  for (int row = 0; row < size.height; ++row)
    for (int column = 0; column < size.width; ++column)
      brightest = std::max(brightest, static_cast<int>(raster.colors(row)[column] & 0xff));
  int edge_pixels = 0, far_off = 0;
  for (int row = 1; row + 1 < size.height; ++row) {
    for (int column = 1; column + 5 < size.width; ++column) {
      int inside = 0;
      for (int i = 0; i < 256; ++i)
        inside += is_white(column + (i % 16 + 0.5) / 16, row + (i / 16 + 0.5) / 16) ? 1 : 0;
      const double seen = static_cast<double>(raster.colors(row)[column] & 0xff) / brightest;
      if (inside == 0 || inside == 256) {
        // Its centre is at least half a pixel from the border: at most the corner of a square
        // pixel farther, where 0.2 of it may be mixed.
        EXPECT_NEAR(seen, inside / 256.0, 0.21) << column << " " << row;
        continue;
      }
      ++edge_pixels;
      far_off += std::abs(seen - inside / 256.0) > 0.13 ? 1 : 0;
    }
  }
  EXPECT_GT(edge_pixels, 60);
  EXPECT_LT(far_off, 0.05 * edge_pixels);  // unmixed, half of them would be
}

TEST(SoftMeeting, TwoSolidsThatCutIntoEachOtherAreMixedByTheirCover) {
  for (const double roll : {0.0, 0.3, 0.8, 1.3}) {
    SceneFrame scene = darkScene();
    const Shape white = wall(kWhite, 0, 0), black = wall(kBlack, roll, 0.6);
    worldOf(scene).obstacles = {{"white", white, {}}, {"black", black, {}}};
    const View view = viewFrom({0, 0.01, 1.013}, 0, {160, 120});
    expectCover(scene, view, [&](double u, double v) {
      return depthOf(white, view, u, v) < depthOf(black, view, u, v);
    });
  }
}

TEST(SoftMeeting, ASolidThatStandsInTheGroundIsMixedWithIt) {
  for (const double roll : {0.1, 0.4, 0.7}) {
    SceneFrame scene = darkScene();
    const Shape box = wall(kWhite, 0, 0);  // from 1 m below the ground on
    worldOf(scene).obstacles = {{"box", box, {}}};
    View view = viewFrom({0, 0, 0.5}, 0, {160, 120});
    view.X_WC.linear() = rotationFromRpy(roll, 0.45, 0);
    expectCover(scene, view, [&](double u, double v) {
      const Vec3 ray = view.X_WC.linear() * Vec3(1, (view.lens.cx - u) / view.lens.fx,
                                                 (view.lens.cy - v) / view.lens.fy);
      return 0.5 + ray.z() * depthOf(box, view, u, v) > 0;
    });
  }
}

// What only hides another thing leaves that alone, and is softened by its own edge.
TEST(SoftMeeting, AThingInFrontOfAnotherIsNotMixedTwice) {
  SceneFrame scene = darkScene();
  worldOf(scene).obstacles = {
      {"front", makeShape(Shape::Kind::Box, {0.01, 0.2, 0.2}, kWhite, {1, 0, 1}), {}},
      {"behind", makeShape(Shape::Kind::Box, {0.01, 4, 4}, kBlack, {1.2, 0, 1}), {}}};
  const View view = viewFrom({0, 0, 1}, 0, {160, 120});
  const double half_width = view.lens.fx * 0.1 / 0.995, half_height = view.lens.fy * 0.1 / 0.995;
  expectCover(scene, view, [&](double u, double v) {
    return std::abs(u - 80) < half_width && std::abs(v - 60) < half_height;
  });
}

}  // namespace
}  // namespace nao::camera
