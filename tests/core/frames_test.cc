#include "core/frames.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace nao {
namespace {

// Rounding of a handful of multiplications of numbers around one.
constexpr double kRounding = 1e-12;

void expectNear(const Pose2& a, const Pose2& b) {
  EXPECT_NEAR(a.x, b.x, kRounding);
  EXPECT_NEAR(a.y, b.y, kRounding);
  EXPECT_NEAR(wrapAngle(a.theta - b.theta), 0, kRounding);
}

TEST(Frames, WrapsAnglesIntoHalfTurns) {
  EXPECT_NEAR(wrapAngle(3 * M_PI / 2), -M_PI / 2, kRounding);
  EXPECT_NEAR(wrapAngle(-3 * M_PI / 2), M_PI / 2, kRounding);
  EXPECT_NEAR(wrapAngle(100 * 2 * M_PI + 0.5), 0.5, 1e-10);
  EXPECT_EQ(wrapAngle(0.25), 0.25);
  EXPECT_EQ(wrapAngle(-M_PI), M_PI);  // the range is half open
  EXPECT_EQ(wrapAngle(M_PI), M_PI);
}

TEST(Frames, ComposeGoesForwardInTheHeadingOfTheBase) {
  expectNear(compose({1, 2, M_PI / 2}, {0.5, 0, 0.1}), {1, 2.5, M_PI / 2 + 0.1});
}

TEST(Frames, RelativeToUndoesCompose) {
  Random random(1, "frames");
  for (int i = 0; i < 200; ++i) {
    const auto any = [&] {
      return Pose2{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-4, 4)};
    };
    const Pose2 base = any();
    const Pose2 step = any();
    expectNear(relativeTo(base, compose(base, step)), step);
    expectNear(compose(base, relativeTo(base, step)), step);
  }
}

TEST(Frames, RollPitchYawComesBack) {
  Random random(2, "frames");
  for (int i = 0; i < 200; ++i) {
    const Vec3 rpy(random.uniform(-3.1, 3.1), random.uniform(-1.5, 1.5), random.uniform(-3.1, 3.1));
    const Vec3 back = rpyOf(rotationFromRpy(rpy.x(), rpy.y(), rpy.z()));
    EXPECT_LT((back - rpy).norm(), 1e-9) << rpy.transpose();  // pitch nears its pole at 1.5
  }
}

TEST(Frames, RollTurnsFirstYawLast) {
  // Lying on the back, nose up: what was ahead points up, whatever the yaw.
  const Mat3 R = rotationFromRpy(0, -M_PI / 2, 1);
  EXPECT_LT((R * Vec3::UnitX() - Vec3::UnitZ()).norm(), kRounding);
  // A quarter roll, then a quarter yaw: left goes up and stays up.
  EXPECT_LT((rotationFromRpy(M_PI / 2, 0, M_PI / 2) * Vec3::UnitY() - Vec3::UnitZ()).norm(),
            kRounding);
}

TEST(Frames, TranslationDoesNotTurn) {
  const Pose X = translation({1, 2, 3});
  EXPECT_EQ(X * Vec3(1, 0, 0), Vec3(2, 2, 3));
}

}  // namespace
}  // namespace nao
