#include "validation/log/series.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::validation {
namespace {

constexpr double kCount = 0.0015;  // [rad]

std::vector<double> counted(double quantum, double beside) {
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) {
    const double angle = 0.4 * std::sin(0.05 * i);
    values.push_back(beside + quantum * std::round(angle / quantum));
  }
  values.push_back(std::nan(""));
  return values;
}

TEST(Series, FindsWhereCountsLie) {
  EXPECT_EQ(findPhase(counted(kCount, 0), kCount), 0);
  EXPECT_NEAR(findPhase(counted(kCount, 0.4 * kCount), kCount), 0.4 * kCount, 1e-9);
  EXPECT_NEAR(findPhase(counted(kCount, 0.7 * kCount), kCount), -0.3 * kCount, 1e-9);
}

TEST(Series, OfOtherCountsOrNoneItSaysNothing) {
  EXPECT_EQ(findPhase(counted(kCount, 0.4 * kCount), 0.83 * kCount), 0);
  EXPECT_EQ(findPhase({}, kCount), 0);
}

}  // namespace
}  // namespace nao::validation
