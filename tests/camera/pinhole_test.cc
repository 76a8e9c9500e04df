#include "camera/pinhole.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::camera {
namespace {

constexpr double kHfov = 0.8343;  // [rad]
constexpr double kVfov = 0.6423;  // [rad]

TEST(Pinhole, TheFieldOfViewEndsAtTheEdges) {
  const Pinhole lens = makePinhole(kHfov, kVfov, {640, 480});
  const auto corner = lens.project(Vec3(1, std::tan(kHfov / 2), std::tan(kVfov / 2)));
  ASSERT_TRUE(corner);
  EXPECT_NEAR(corner->x(), 0, 1e-10);
  EXPECT_NEAR(corner->y(), 0, 1e-10);
}

TEST(Pinhole, LeftIsLeftAndUpIsUp) {
  const Pinhole lens = makePinhole(kHfov, kVfov, {640, 480});
  EXPECT_LT(lens.project(Vec3(1, 0.1, 0))->x(), 320);
  EXPECT_LT(lens.project(Vec3(1, 0, 0.1))->y(), 240);
  EXPECT_NEAR(lens.project(Vec3(5, 0, 0))->x(), 320, 1e-12);
}

TEST(Pinhole, NothingBehindTheCameraFallsOnThePicture) {
  const Pinhole lens = makePinhole(kHfov, kVfov, {640, 480});
  EXPECT_FALSE(lens.project(Vec3(0, 1, 1)));
  EXPECT_FALSE(lens.project(Vec3(-1, 0, 0)));
}

TEST(Pinhole, FocalLengthAgreesWithTheLibrarysTangent) {
  for (const double fov : {0.3, 0.8343, 1.0629, 2.0}) {
    const Pinhole lens = makePinhole(fov, fov, {640, 480});
    EXPECT_NEAR(lens.fx, 320 / std::tan(fov / 2), 1e-10) << fov;  // rounding of 24 terms
  }
}

}  // namespace
}  // namespace nao::camera
