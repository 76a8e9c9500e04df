#include "validation/diagnosis/maths/slope_steps.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace nao::validation {
namespace {

constexpr Eigen::Index kRows = 4000;

Eigen::VectorXd drawn(Random& random, double sd) {
  Eigen::VectorXd x(kRows);
  for (double& one : x) one = sd * random.normal();
  return x;
}

// Two slopes as two halves of an ensemble see them, with chance of `sd` per row in either half.
struct Seen {
  Eigen::MatrixXd slopes{kRows, 2}, chance{kRows, 2};
};

Seen seen(const Eigen::MatrixXd& truth, double sd, Random& random) {
  Seen seen;
  for (Eigen::Index i = 0; i < 2; ++i) {
    const Eigen::VectorXd first = truth.col(i) + drawn(random, sd);
    const Eigen::VectorXd second = truth.col(i) + drawn(random, sd);
    seen.slopes.col(i) = (first + second) / 2;
    seen.chance.col(i) = (first - second) / 2;
  }
  return seen;
}

Eigen::MatrixXd twoAlike(Random& random) {
  Eigen::MatrixXd truth(kRows, 2);
  truth.col(0) = drawn(random, 1);
  truth.col(1) = 0.6 * truth.col(0) + drawn(random, 0.8);
  return truth;
}

TEST(SlopeSteps, WithoutChanceAreThoseOfLeastSquares) {
  Random random(1, "slopes");
  const Eigen::MatrixXd slopes = twoAlike(random);
  const Eigen::VectorXd step =
      SlopeSteps(slopes, Eigen::MatrixXd::Zero(kRows, 2))(slopes * Eigen::Vector2d(0.7, -2));
  EXPECT_NEAR(step[0], 0.7, 1e-9);
  EXPECT_NEAR(step[1], -2, 1e-9);
}

// A stop that no motion reaches has a slope of exactly nothing before encoders round: that was a
// segmentation fault.
TEST(SlopeSteps, AlongNothingMoveNothing) {
  const Eigen::MatrixXd none = Eigen::MatrixXd::Zero(kRows, 2);
  const Eigen::VectorXd step = SlopeSteps(none, none)(Eigen::VectorXd::Ones(kRows));
  ASSERT_EQ(step.size(), 2);
  EXPECT_EQ(step, Eigen::Vector2d::Zero());
}

// Chance of one SD in each half is a third of the squares: plain least squares would go two thirds
// of the way. What is left: the chance's product with the residual, 0.7 * 1.6 / sqrt(4000) = 0.018,
// and the error of its own squares, 0.02, both by 1.2 / 0.64 as the slopes are alike: an SD of
// 0.05.
TEST(SlopeSteps, GoAllTheWayAlongSlopesThatHoldChance) {
  Random random(2, "slopes");
  const Eigen::MatrixXd truth = twoAlike(random);
  const Seen half = seen(truth, 1, random);
  const Eigen::VectorXd step = SlopeSteps(half.slopes, half.chance)(truth * Eigen::Vector2d(1, -2));
  EXPECT_NEAR(step[0], 1, 0.15);
  EXPECT_NEAR(step[1], -2, 0.15);
}

TEST(SlopeSteps, OfChanceAloneStayFinite) {
  Random random(3, "slopes");
  const Seen half = seen(Eigen::MatrixXd::Zero(kRows, 2), 1, random);
  const Eigen::VectorXd y = drawn(random, 1);
  const Eigen::VectorXd step = SlopeSteps(half.slopes, half.chance)(y);
  // At most five times what least squares takes of a residual that has nothing to do with them.
  EXPECT_LT(step.norm(), 5 * 4 * std::sqrt(2.0 / kRows) / std::sqrt(0.5));
  EXPECT_GT(step.norm(), 0);
}

TEST(SlopeSteps, AlongOneSlopeGivenTwiceShareTheStep) {
  Random random(4, "slopes");
  Eigen::MatrixXd slopes(kRows, 2);
  slopes.col(0) = drawn(random, 1);
  slopes.col(1) = slopes.col(0);
  const Eigen::VectorXd step =
      SlopeSteps(slopes, Eigen::MatrixXd::Zero(kRows, 2))(3 * slopes.col(0));
  EXPECT_NEAR(step.sum(), 3, 1e-9);
}

}  // namespace
}  // namespace nao::validation
