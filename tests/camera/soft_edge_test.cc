#include <gtest/gtest.h>

#include <cmath>

#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

int redOf(Pixel pixel) { return static_cast<int>(pixel & 0xff); }

SceneFrame darkScene() {
  SceneFrame scene = emptyScene();
  worldOf(scene).ground_color = worldOf(scene).sky_color = {0, 0, 0};
  worldOf(scene).ground_size = {1e7, 1e7};
  return scene;
}

/// A white slab that stands across the view, 1 m away, turned by `roll` about the line of sight.
void addSlab(SceneFrame& scene, double roll) {
  Shape slab = makeShape(Shape::Kind::Box, {0.01, 0.2, 0.2}, {255, 255, 255}, {1.005, 0, 1});
  slab.X_BS.linear() = rotationFromRpy(roll, 0, 0);
  worldOf(scene).obstacles.push_back({"slab", slab, {}});
}

/// How much of each pixel the slab covers, by 16 x 16 points in each.
double coverOf(const View& view, double roll, int column, int row) {
  int inside = 0;
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 16; ++x) {
      const double left = (view.lens.cx - column - (x + 0.5) / 16) / view.lens.fx;
      const double up = (view.lens.cy - row - (y + 0.5) / 16) / view.lens.fy;
      const double a = std::cos(roll) * left + std::sin(roll) * up;
      const double b = -std::sin(roll) * left + std::cos(roll) * up;
      inside += std::abs(a) <= 0.1 && std::abs(b) <= 0.1 ? 1 : 0;
    }
  }
  return inside / 256.0;
}

// The edge's cover is that of a line straight through the pixel's row (column): off by at most an
// eighth of a pixel where it leaves the pixel inside the row, and by more at the slab's corners.
TEST(SoftEdge, EdgePixelsAreAsBrightAsTheyAreCovered) {
  for (const double roll : {0.0, 0.1, 0.4, 0.7}) {
    SceneFrame scene = darkScene();
    addSlab(scene, roll);
    const View view = viewFrom({0, 0, 1}, 0, {320, 240});
    Renderer renderer;
    const Raster& raster = renderer.render(scene, view);
    const double full = redOf(raster.colors(120)[160]);
    ASSERT_GT(full, 150);
    double worst = 0, sum = 0, covered = 0;
    int edge_pixels = 0;
    for (int row = 0; row < 240; ++row) {
      for (int column = 0; column < 320; ++column) {
        const double cover = coverOf(view, roll, column, row);
        const double seen = redOf(raster.colors(row)[column]) / full;
        sum += seen;
        covered += cover;
        if (cover == 0 || cover == 1) continue;
        ++edge_pixels;
        worst = std::max(worst, std::abs(seen - cover));
      }
    }
    ASSERT_GT(edge_pixels, 100) << roll;
    EXPECT_LT(worst, 0.5) << roll;                       // at the corners, where two edges meet
    EXPECT_NEAR(sum, covered, 0.003 * covered) << roll;  // the whole slab's area
  }
}

// Without soft edges a pixel is black or white: then half of them would be off by more than 0.25.
TEST(SoftEdge, FewEdgePixelsAreFarFromTheirCover) {
  SceneFrame scene = darkScene();
  addSlab(scene, 0.3);
  const View view = viewFrom({0, 0, 1}, 0, {320, 240});
  Renderer renderer;
  const Raster& raster = renderer.render(scene, view);
  const double full = redOf(raster.colors(120)[160]);
  int edge_pixels = 0, far_off = 0;
  for (int row = 0; row < 240; ++row) {
    for (int column = 0; column < 320; ++column) {
      const double cover = coverOf(view, 0.3, column, row);
      if (cover == 0 || cover == 1) continue;
      ++edge_pixels;
      far_off += std::abs(redOf(raster.colors(row)[column]) / full - cover) > 0.13 ? 1 : 0;
    }
  }
  EXPECT_LT(far_off, 0.05 * edge_pixels);
}

TEST(SoftEdge, AHiddenEdgeLeavesWhatHidesItAlone) {
  SceneFrame scene = darkScene();
  worldOf(scene).obstacles.push_back(
      {"front", makeShape(Shape::Kind::Box, {0.01, 2, 2}, {200, 0, 0}, {0.5, 0, 1}), {}});
  Renderer renderer;
  const View view = viewFrom({0, 0, 1.5}, 0.3, {160, 120});
  const Pixel before = renderer.render(scene, view).colors(100)[80];
  worldOf(scene).obstacles.push_back(
      {"behind", makeShape(Shape::Kind::Box, {0.3, 0.2, 0.2}, {0, 255, 0}, {1, 0, 1}), {}});
  const Raster& raster = renderer.render(scene, view);
  for (int row = 60; row < 120; ++row) {
    for (int column = 40; column < 120; ++column) {
      EXPECT_EQ(raster.colors(row)[column] >> 8 & 0xff, before >> 8 & 0xff) << row << " " << column;
    }
  }
}

}  // namespace
}  // namespace nao::camera
