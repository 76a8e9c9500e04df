#include "motion/speed_profile.h"

#include <gtest/gtest.h>

namespace nao::motion {
namespace {

TEST(SpeedProfile, GoesFromNothingToEverything) {
  const SpeedProfile profile(2, 0.4);
  EXPECT_DOUBLE_EQ(profile.at(0), 0);
  EXPECT_DOUBLE_EQ(profile.duration(), 2.4);
  EXPECT_DOUBLE_EQ(profile.at(2.4), 1);
  EXPECT_NEAR(profile.at(1.2), 0.5, 1e-12);
}

TEST(SpeedProfile, NeverPassesItsTopSpeedNorTurnsBack) {
  for (const double way_time : {0.05, 0.3, 2.0}) {
    const SpeedProfile profile(way_time, 0.4);
    double before = 0;
    double fastest = 0;
    const double step = profile.duration() / 1000;
    for (int i = 1; i <= 1000; ++i) {
      const double now = profile.at(i * step);
      EXPECT_GE(now, before);
      fastest = std::max(fastest, (now - before) / step);
      before = now;
    }
    EXPECT_LE(fastest, 1 / way_time * (1 + 1e-9));
    EXPECT_GT(fastest, 0.95 / way_time);  // and the top speed is used
  }
}

TEST(SpeedProfile, HasItsSpeedWithoutAJump) {
  const SpeedProfile profile(1, 0.4);
  double speed_before = 0;
  for (double time = 0; time < 1.4; time += 0.01) {
    const double speed = (profile.at(time + 0.01) - profile.at(time)) / 0.01;
    EXPECT_LT(std::abs(speed - speed_before), 0.04) << time;  // 1.5 / 0.4 s * 10 ms
    speed_before = speed;
  }
}

TEST(SpeedProfile, WithoutAWayIsOverAtOnce) {
  EXPECT_DOUBLE_EQ(SpeedProfile(0, 0.4).duration(), 0);
  EXPECT_DOUBLE_EQ(SpeedProfile(0, 0.4).at(0), 1);
}

}  // namespace
}  // namespace nao::motion
