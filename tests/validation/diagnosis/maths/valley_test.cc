#include "validation/diagnosis/maths/valley.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace nao::validation {
namespace {

// A gyroscope that exaggerates by 0.35, in a walk: costs of 600 nats, of which 15 are chance. That
// moves the vertex through neighbours 0.1 apart by 15 * sqrt(2) / (4 * 5000 * 0.1) = 0.01: thrice
// that is allowed.
TEST(Valley, IsFoundThroughChanceInTheCost) {
  constexpr double kTruth = 0.3456;
  for (const double start : {0.02, 0.1, 0.35, 2.0}) {
    Random random(1, "cost");
    int asked = 0;
    const auto cost = [&](double x) {
      ++asked;
      return 5000 * (x - kTruth) * (x - kTruth) + 15 * random.normal();
    };
    EXPECT_NEAR(lowestAlong(cost, start, -1, 5), kTruth, 0.03) << start;
    EXPECT_LE(asked, 11) << start;
  }
}

TEST(Valley, OfAParabolaIsMetExactly) {
  const auto cost = [](double x) { return (x + 0.03) * (x + 0.03); };
  EXPECT_NEAR(lowestAlong(cost, -0.02, -1, 1), -0.03, 1e-12);
}

// A motor that is left with a tenth of its torque follows, with less it does not: beyond the lowest
// place costs rise at once. Such a limit of an ankle was left at where its fit began, and told as a
// weak gain.
TEST(Valley, WithOneSteepSideIsNarrowedDown) {
  const auto cost = [](double x) { return x < -0.9 ? 8e5 * (-0.9 - x) : 4e3 * (x + 0.9); };
  EXPECT_NEAR(lowestAlong(cost, -0.84, -1, 0), -0.9, 0.02);
}

TEST(Valley, EndsAtABound) {
  const auto cost = [](double x) { return -x; };
  EXPECT_EQ(lowestAlong(cost, 0.4, -1, 1), 1);
  EXPECT_EQ(lowestAlong(cost, -0.4, -1, -0.1), -0.1);
}

TEST(Valley, OfNothingIsWhereItBegan) {
  EXPECT_EQ(lowestAlong([](double) { return 1.0; }, 0, -1, 1), 0);
  EXPECT_EQ(lowestAlong([](double) { return 1.0; }, 0.3, -1, 1), 0.3);
}

}  // namespace
}  // namespace nao::validation
