#include "validation/diagnosis/ensemble/start_offsets.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::validation {
namespace {

constexpr double kDt = 0.01;  // [s]

Eigen::VectorXd course(double late) {
  Eigen::VectorXd angle(600);
  for (Eigen::Index i = 0; i < angle.size(); ++i) {
    angle[i] = 0.3 * std::sin(2 * (static_cast<double>(i) * kDt - late));
  }
  return angle;
}

double error(const std::vector<Eigen::MatrixXd>& runs, std::size_t r) {
  // Without the first and last sample, whose rate nobody knows.
  return (runs[r].col(0) - course(0)).segment(1, 598).cwiseAbs().maxCoeff();
}

// 1.5 ms at 0.6 rad/s are 0.9 mrad; what is left is of second order, 0.3 * (2 * 1.5e-3)^2 / 2.
TEST(StartOffsets, TakesOffThatRunsBeganEarlyOrLate) {
  const auto runs = startedAlike({course(1.5e-3), course(-1e-3)}, course(0), kDt, 1.5e-3);
  EXPECT_LT(error(runs, 0), 3e-6);
  EXPECT_LT(error(runs, 1), 3e-6);
}

// Two starts of SD 1 ms have a mean of SD 0.7 ms: 2.1 of 5 are chance at most, 2.9 are a delay.
TEST(StartOffsets, LeavesADelayThatAllRunsShare) {
  const auto runs = startedAlike({course(6e-3), course(4e-3)}, course(0), kDt, 1e-3);
  const double left = (5 - 3 / std::sqrt(2.0)) * 1e-3 * 0.6;  // [rad]
  EXPECT_NEAR(error(runs, 0), left, 0.02 * left);
  EXPECT_NEAR(error(runs, 1), left, 0.02 * left);
}

// Six runs of a motion were seen to begin 3.2 SDs early on the mean, where nothing was wrong.
TEST(StartOffsets, OneMotionOfASetMayHaveBegunLateByChance) {
  const auto runs = startedAlike({course(2.5e-3), course(1.5e-3)}, course(0), kDt, 1e-3);
  EXPECT_LT(error(runs, 0), 4e-6);
}

// 20 Hz are five samples a period.
TEST(StartOffsets, RateOfAJointThatJumpsIsKnownBetweenSamples) {
  const double turn = 2 * M_PI * 20;  // [rad/s]
  Eigen::VectorXd angle(600), exact(600);
  for (Eigen::Index i = 0; i < angle.size(); ++i) {
    angle[i] = 0.01 * std::sin(turn * static_cast<double>(i) * kDt);
    exact[i] = 0.01 * turn * std::cos(turn * static_cast<double>(i) * kDt);
  }
  const Eigen::VectorXd rate = rateBetweenSamples(angle, kDt);
  EXPECT_LT((rate - exact).segment(10, 580).cwiseAbs().maxCoeff(), 0.02 * 0.01 * turn);
  EXPECT_EQ(rate[0], 0);
  EXPECT_EQ(rate[599], 0);
}

TEST(StartOffsets, AreNoneWhereNothingMovesOrStartsAreExact) {
  const Eigen::VectorXd rest = Eigen::VectorXd::Constant(600, 0.2);
  const std::vector<Eigen::MatrixXd> runs{course(2e-3)};
  EXPECT_EQ(startedAlike(runs, rest, kDt, 1e-3)[0], runs[0]);
  EXPECT_EQ(startedAlike(runs, course(0), kDt, 0)[0], runs[0]);
}

}  // namespace
}  // namespace nao::validation
