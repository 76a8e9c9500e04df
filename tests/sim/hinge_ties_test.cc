#include "sim/hinge_ties.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "core/random.h"

namespace nao::sim {
namespace {

// Two motors, of three hinges and of two: speeds 0 1 3 and 2 4 after one of the root.
RobotModel fiveHinges() {
  RobotModel model;
  model.actuators.resize(2);
  model.actuators[0].coordinates = {0, 1, 3};
  model.actuators[1].coordinates = {2, 4};
  return model;
}

TEST(HingeTies, AllHoldAtOnceAndPushOnNothingElse) {
  Random random(5);
  Eigen::MatrixXd A = Eigen::MatrixXd::NullaryExpr(6, 6, [&] { return random.uniform(-1, 1); });
  A = A * A.transpose() + 0.1 * Eigen::MatrixXd::Identity(6, 6);
  const Eigen::LDLT<Eigen::MatrixXd> factors(A);
  const Eigen::VectorXd f = Eigen::VectorXd::LinSpaced(6, -1, 2);
  Eigen::VectorXd x = factors.solve(f);
  HingeTies ties(fiveHinges(), 1);
  ties.hold([&](Eigen::VectorXd& c) { c = factors.solve(c).eval(); },
            [](int a, int b) { return 0.1 * a + 0.01 * b; }, x);

  constexpr double kRounding = 1e-12;
  EXPECT_NEAR(x[1] - x[2], 0.1 + 0.02, kRounding);
  EXPECT_NEAR(x[1] - x[4], 0.1 + 0.04, kRounding);
  EXPECT_NEAR(x[3] - x[5], 0.3 + 0.05, kRounding);
  const Eigen::VectorXd impulse = A * x - f;  // between the hinges of a motor alone
  EXPECT_NEAR(impulse[0], 0, kRounding);
  EXPECT_NEAR(impulse[1] + impulse[2] + impulse[4], 0, kRounding);
  EXPECT_NEAR(impulse[3] + impulse[5], 0, kRounding);
}

}  // namespace
}  // namespace nao::sim
