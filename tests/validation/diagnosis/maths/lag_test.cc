#include "validation/diagnosis/maths/lag.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::validation {
namespace {

Eigen::VectorXd swing(double late) {
  Eigen::VectorXd rows(200);
  for (Eigen::Index i = 0; i < rows.size(); ++i) {
    rows[i] = std::sin(0.05 * (static_cast<double>(i) - late));
  }
  return rows;
}

TEST(Lag, IsFoundToATenthOfARow) { EXPECT_NEAR(rowsLate(swing(3.6), swing(0)), 3.6, 0.051); }

TEST(Lag, IsNoneOfWhatRests) {
  EXPECT_EQ(rowsLate(Eigen::VectorXd::Constant(50, 0.3), Eigen::VectorXd::Constant(50, 0.2)), 0);
}

// A straight line between rows is off by at most (0.05 / 2)^2 / 2.
TEST(Lag, GoesWhereItIsTakenBack) {
  const Eigen::VectorXd back = earlier(swing(3.6), 3.6);
  EXPECT_LT((back - swing(0)).head(196).cwiseAbs().maxCoeff(), 3.2e-4);
  EXPECT_EQ(back[199], swing(3.6)[199]);
}

}  // namespace
}  // namespace nao::validation
