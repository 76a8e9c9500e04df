#include "daemon/pace.h"

#include <gtest/gtest.h>

#include <limits>

namespace nao::daemon {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""h;

const Pace::Wall kStart{std::chrono::seconds(1000)};

TEST(Pace, WaitsForTheWallClockAtItsSpeed) {
  Pace pace(2, SimTime{}, kStart);
  EXPECT_EQ(pace.due(SimTime(100ms), kStart), kStart + 50ms);
}

TEST(Pace, NeverWaitsAtFullSpeed) {
  Pace pace(std::numeric_limits<double>::infinity(), SimTime{}, kStart);
  EXPECT_LE(pace.due(SimTime(3600000ms), kStart), kStart);
}

TEST(Pace, AtAlmostNoSpeedItWaitsAlmostForEver) {
  for (const double speed : {1e-12, std::numeric_limits<double>::denorm_min()}) {
    Pace pace(speed, SimTime{}, kStart);
    EXPECT_GT(pace.due(SimTime(10ms), kStart), kStart + 1000h);
  }
}

TEST(Pace, CatchesUpALittleLateness) {
  Pace pace(1, SimTime{}, kStart);
  EXPECT_EQ(pace.due(SimTime(10ms), kStart + 60ms), kStart + 10ms);
  EXPECT_EQ(pace.due(SimTime(70ms), kStart + 60ms), kStart + 70ms);
}

TEST(Pace, LosesTimeOnAHostThatIsTooSlow) {
  Pace pace(1, SimTime{}, kStart);
  pace.due(SimTime(10ms), kStart + 5000ms);
  EXPECT_EQ(pace.due(SimTime(20ms), kStart + 5000ms), kStart + 5010ms);
}

TEST(Pace, CatchesUpNoMoreThanItsPatience) {
  Pace pace(1, SimTime{}, kStart);
  pace.setPatience(12ms);
  EXPECT_EQ(pace.due(SimTime(12ms), kStart + 24ms), kStart + 12ms);
  EXPECT_EQ(pace.due(SimTime(24ms), kStart + 24ms), kStart + 24ms);
  pace.due(SimTime(36ms), kStart + 60ms);
  EXPECT_EQ(pace.due(SimTime(48ms), kStart + 60ms), kStart + 72ms);
}

}  // namespace
}  // namespace nao::daemon
