#include "validation/diagnosis/maths/least_squares.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::validation {
namespace {

Eigen::VectorXd decay(double size, double rate) {
  Eigen::VectorXd curve(50);
  for (int i = 0; i < 50; ++i) curve[i] = size * std::exp(-rate * 0.1 * i);
  return curve;
}

FitPoint fit(double upper) {
  FitSpace space{{1, 0.5}, {0, 0}, {upper, 10}, {1e-3, 1e-3}, 20};
  return leastSquares(
      [](const std::vector<double>& x) -> Eigen::VectorXd {
        return decay(x[0], x[1]) - decay(2, 1.5);
      },
      space);
}

TEST(LeastSquares, FindsBothNumbersOfACurve) {
  const FitPoint found = fit(10);
  EXPECT_NEAR(found.x[0], 2, 1e-3);
  EXPECT_NEAR(found.x[1], 1.5, 1e-3);
}

// A model whose last cause is taken out.
TEST(LeastSquares, WithoutANumberIsWhatIsLeft) {
  const FitPoint left = leastSquares([](const auto&) { return decay(2, 1.5); }, {});
  EXPECT_TRUE(left.x.empty());
  EXPECT_EQ(left.cost, decay(2, 1.5).squaredNorm() / 2);
  EXPECT_EQ(left.jacobian.cols(), 0);
}

TEST(LeastSquares, DifferencesAreAsNarrowAsAsked) {
  FitSpace space{{1}, {0}, {2}, {1e-3}};
  EXPECT_NEAR(differenceStep(space, 0, 1), 0.05, 1e-12);
  space.part = 0;
  EXPECT_NEAR(differenceStep(space, 0, 1), 1e-3, 1e-12);
}

TEST(LeastSquares, AFixedNumberLeavesTheOthersToFit) {
  const FitSpace space{{2, 0.5}, {2, 0}, {2, 10}, {1e-3, 1e-3}, 20};
  const FitPoint found = leastSquares(
      [](const std::vector<double>& x) -> Eigen::VectorXd {
        return decay(x[0], x[1]) - decay(2, 1.5);
      },
      space);
  EXPECT_EQ(found.x[0], 2);
  EXPECT_NEAR(found.x[1], 1.5, 1e-3);
}

TEST(LeastSquares, StaysWithinBounds) { EXPECT_NEAR(fit(1.7).x[0], 1.7, 1e-6); }

}  // namespace
}  // namespace nao::validation
