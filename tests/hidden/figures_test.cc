#include "tests/hidden/figures.h"

#include <gtest/gtest.h>

namespace nao::hidden {
namespace {

TEST(Fraction, HasWilsonsInterval) {
  const Fraction none{0, 200}, most{186, 200};
  EXPECT_EQ(none.low(), 0);
  EXPECT_NEAR(none.high(), 0.0188, 1e-4);  // z^2 / (n + z^2)
  EXPECT_NEAR(most.low(), 0.8861, 2e-4);
  EXPECT_NEAR(most.high(), 0.9577, 2e-4);
}

TEST(Figures, NothingDoneIsNothingFound) {
  const Figures figures = figuresOf({});
  EXPECT_EQ(figures.singles, 0);
  EXPECT_NE(toJson(figures, "quick", 0).find("\"exact_null_false_alarms\": 0"), std::string::npos);
}

}  // namespace
}  // namespace nao::hidden
