// Where things fall on the picture, by each camera's published field of view: held against the
// analytic projection.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "camera/renderer.h"
#include "tests/camera/scenes.h"

namespace nao::camera {
namespace {

constexpr Color kBlack{0, 0, 0};
constexpr Color kWhite{255, 255, 255};

SceneFrame blackScene() {
  SceneFrame scene = emptyScene();
  worldOf(scene).ground_color = kBlack;
  worldOf(scene).sky_color = kBlack;
  worldOf(scene).ground_size = {1e7, 1e7};
  return scene;
}

int redOf(Pixel pixel) { return static_cast<int>(pixel & 0xff); }

class Projection : public testing::TestWithParam<PublishedLens> {
 protected:
  View viewFrom(const Vec3& p_W, double pitch, ImageSize size = {640, 480}) const {
    View view = camera::viewFrom(p_W, pitch, size);
    view.lens = GetParam().pinhole(size);
    return view;
  }
};
INSTANTIATE_TEST_SUITE_P(Sensors, Projection, testing::ValuesIn(kPublishedLenses),
                         [](const auto& lens) { return std::string(lens.param.sensor); });

/// The unit vectors that touch a sphere all around, in the camera's frame.
std::vector<Vec3> raysAlongOutline(const Vec3& centre_C, double radius, int count) {
  const double half = std::asin(radius / centre_C.norm());
  const Vec3 axis = centre_C.normalized();
  const Vec3 side = axis.cross(Vec3::UnitZ()).normalized();
  const Vec3 up = side.cross(axis);
  std::vector<Vec3> rays;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * M_PI * i / count;
    rays.push_back(std::cos(half) * axis +
                   std::sin(half) * (std::cos(angle) * side + std::sin(angle) * up));
  }
  return rays;
}

/// A white ball is seen within a pixel of its true outline: a pixel inside of it is white, a pixel
/// outside is black, all around.
void expectOutline(const View& view, const Vec3& centre_W, double radius) {
  SceneFrame scene = blackScene();
  scene.balls.push_back({radius, centre_W, kWhite, Mat3::Identity()});
  Renderer renderer;
  const Raster& raster = renderer.render(scene, view);
  const Vec3 centre_C = view.X_WC.inverse() * centre_W;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  const auto rays = raysAlongOutline(centre_C, radius, 72);
  for (const Vec3& ray : rays) middle += *view.lens.project(ray) / rays.size();
  for (const Vec3& ray : rays) {
    const Eigen::Vector2d edge = *view.lens.project(ray);
    const Eigen::Vector2d out = (edge - middle).normalized();
    const auto isBall = [&](const Eigen::Vector2d& p) {
      return redOf(raster.colors(static_cast<int>(p.y()))[static_cast<int>(p.x())]) > 90;
    };
    EXPECT_TRUE(isBall(edge - out)) << edge.transpose();
    EXPECT_FALSE(isBall(edge + out)) << edge.transpose();
  }
}

TEST_P(Projection, ASpheresSilhouetteIsWithinAPixel) {
  expectOutline(viewFrom({0, 0, 1}, 0), {0.5, 0, 1}, 0.0325);
  expectOutline(viewFrom({0, 0, 1}, 0), {0.4, 0.1, 1.08}, 0.0325);
  expectOutline(viewFrom({0, 0, 0.5}, 0.6), {0.5, -0.1, 0.12}, 0.05);
  expectOutline(viewFrom({0, 0, 0.5}, 0.3, {320, 240}), {1.5, 0.2, 0.1}, 0.05);
  expectOutline(viewFrom({0, 0, 0.5}, 0.1, {1280, 960}), {3, -0.5, 0.05}, 0.05);
}

TEST_P(Projection, ABallsSizeIsThePinholes) {
  const View view = viewFrom({0, 0, 1}, 0);
  SceneFrame scene = blackScene();
  scene.balls.push_back({0.0325, {0.5, 0, 1}, kWhite, Mat3::Identity()});
  Renderer renderer;
  const Raster& raster = renderer.render(scene, view);
  std::ptrdiff_t area = 0;  // [px] of the ball's colour, more than black's by half
  for (int row = 0; row < 480; ++row) {
    const Pixel* const pixels = raster.colors(row);
    area += std::count_if(pixels, pixels + 640, [](Pixel p) { return redOf(p) >= 90; });
  }
  const double radius = view.lens.fx * 0.0325 / std::sqrt(0.5 * 0.5 - 0.0325 * 0.0325);
  EXPECT_NEAR(std::sqrt(static_cast<double>(area) / M_PI), radius, 0.5);
}

struct Stripe {
  double centre = 0;     // [px]
  double thickness = 0;  // [px]
};

/// The white along the middle column below the horizon: how much, and where its middle is.
Stripe stripeInMiddle(const Raster& raster, double horizon) {
  Stripe stripe;
  for (int row = static_cast<int>(horizon + 1); row < raster.size().height; ++row) {
    const double part = redOf(raster.colors(row)[raster.size().width / 2]) / 255.0;
    stripe.thickness += part;
    stripe.centre += part * (row + 0.5);
  }
  stripe.centre /= stripe.thickness;
  return stripe;
}

TEST_P(Projection, ALineAcrossFallsWhereThePinholeSays) {
  for (const double distance : {1.3, 2.0, 5.0, 15.0}) {
    SceneFrame scene = blackScene();
    addLine(worldOf(scene), distance, -50, distance, 50);
    Renderer renderer;
    const View view = viewFrom({0, 0, 0.5}, 0.1);
    const double horizon = view.lens.cy - view.lens.fy * std::tan(0.1);
    const Stripe seen = stripeInMiddle(renderer.render(scene, view), horizon);
    const auto row = [&](double x) {
      return view.lens.project(view.X_WC.inverse() * Vec3(x, 0, 0))->y();
    };
    const double near_edge = row(distance - 0.025);
    const double far_edge = row(distance + 0.025);
    // Half a step of 255 in weight and in colour, for the two pixels of the edges. The middle of
    // a line thinner than a pixel is the middle of that pixel.
    EXPECT_NEAR(seen.thickness, near_edge - far_edge, 0.01) << distance;
    EXPECT_NEAR(seen.centre, (near_edge + far_edge) / 2, seen.thickness < 1 ? 0.5 : 0.05)
        << distance;
  }
}

TEST_P(Projection, ALineAwayFallsWhereThePinholeSays) {
  SceneFrame scene = blackScene();
  addLine(worldOf(scene), -100, 0.3, 100, 0.3);
  Renderer renderer;
  const View view = viewFrom({0, 0, 0.5}, 0);
  const Raster& raster = renderer.render(scene, view);
  for (const int row : {300, 400, 470}) {
    const double depth = view.lens.fy * 0.5 / (row + 0.5 - view.lens.cy);
    double sum = 0;
    double weighted = 0;
    for (int column = 0; column < 640; ++column) {
      sum += redOf(raster.colors(row)[column]);
      weighted += redOf(raster.colors(row)[column]) * (column + 0.5);
    }
    EXPECT_NEAR(weighted / sum, view.lens.cx - view.lens.fx * 0.3 / depth, 0.2) << row;
    EXPECT_NEAR(sum / 255, view.lens.fx * 0.05 / depth, 0.2) << row;
  }
}

TEST_P(Projection, TheHorizonIsAtEyeHeight) {
  SceneFrame scene = emptyScene();
  Renderer renderer;
  const View view = viewFrom({0, 0, 0.5}, 0.2);
  const Raster& raster = renderer.render(scene, view);
  const double horizon = view.lens.cy - view.lens.fy * std::tan(0.2);
  const int last_of_sky = static_cast<int>(horizon - 1);
  EXPECT_TRUE(isColor(raster.colors(last_of_sky)[100], scene.world->sky_color));
  EXPECT_FALSE(isColor(raster.colors(last_of_sky + 2)[100], scene.world->sky_color));
  EXPECT_TRUE(isColor(raster.colors(479)[100], scene.world->ground_color));
}

}  // namespace
}  // namespace nao::camera
