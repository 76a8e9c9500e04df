#include "core/sim_time.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace nao {
namespace {

using std::chrono::hours;
using std::chrono::milliseconds;

TEST(SimTime, StartsAtZeroAndCountsNanoseconds) {
  EXPECT_EQ(toSeconds(SimTime{}), 0);
  EXPECT_EQ(toSeconds(SimTime{} + milliseconds(1500)), 1.5);
  EXPECT_EQ(toSeconds(Duration(1)), 1e-9);
}

TEST(SimTime, RoundsSecondsToTheNearestNanosecond) {
  EXPECT_EQ(fromSeconds(0.002), milliseconds(2));
  EXPECT_EQ(fromSeconds(-0.002), milliseconds(-2));
  EXPECT_EQ(fromSeconds(1.4e-9), Duration(1));
  EXPECT_EQ(fromSeconds(1.6e-9), Duration(2));
  EXPECT_EQ(fromSeconds(-1.6e-9), Duration(-2));
}

TEST(SimTime, TenMillisecondsAddUpWithoutDrift) {
  SimTime time{};
  for (int i = 0; i < 360000; ++i) time += milliseconds(10);
  EXPECT_EQ(time, SimTime{} + hours(1));
}

TEST(SimTime, DoesNotMixWithTheWallClock) {
  EXPECT_FALSE((std::is_convertible_v<std::chrono::steady_clock::time_point, SimTime>));
  EXPECT_FALSE((std::is_convertible_v<std::chrono::system_clock::time_point, SimTime>));
}

}  // namespace
}  // namespace nao
