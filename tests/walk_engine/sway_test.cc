#include "walk_engine/sway.h"

#include <gtest/gtest.h>

namespace nao::walk {
namespace {

constexpr std::array<bool, 2> kBoth{true, true}, kLeft{true, false}, kRight{false, true};

// One step on one foot, leaning out over it by `lean` [rad] at most, then both feet.
void step(Sway& sway, std::array<bool, 2> stands, double lean) {
  const double side = stands[0] ? -1 : 1;  // roll is positive to the right
  for (const double part : {0.2, 1.0, 0.5}) sway.watch(side * part * lean, stands);
  sway.watch(0, kBoth);
}

TEST(Sway, LeavesAnUndisturbedWalkAlone) {
  Tuning tuning;
  Sway sway(tuning);
  for (int i = 0; i < 10; ++i) step(sway, i % 2 ? kLeft : kRight, 0.9 * tuning.usual_lean);
  EXPECT_EQ(sway.inset(), 0);
}

TEST(Sway, MovesThePressureInwardByWhatIsBeyondTheUsualLeanOverEitherFoot) {
  Tuning tuning;
  for (const auto& foot : {kLeft, kRight}) {
    Sway sway(tuning);
    step(sway, foot, tuning.usual_lean + 0.01);
    EXPECT_NEAR(sway.inset(), tuning.sway_gain * 0.01, 1e-12);
  }
}

TEST(Sway, ForgetsStepByStep) {
  Tuning tuning;
  Sway sway(tuning);
  step(sway, kLeft, tuning.usual_lean + 0.02);
  const double inset = sway.inset();
  step(sway, kRight, 0);
  EXPECT_NEAR(sway.inset(), tuning.sway_memory * inset, 1e-12);
}

TEST(Sway, DoesNotCountALeanTowardsTheSwingingFoot) {
  Tuning tuning;
  Sway sway(tuning);
  step(sway, kLeft, -0.1);
  EXPECT_EQ(sway.inset(), 0);
}

TEST(Sway, HasAnEnd) {
  Sway sway((Tuning()));
  for (int i = 0; i < 20; ++i) step(sway, kLeft, 0.5);
  EXPECT_LE(sway.inset(), 0.015);
  EXPECT_GT(sway.inset(), 0.01);
}

}  // namespace
}  // namespace nao::walk
