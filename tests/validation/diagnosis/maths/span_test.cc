#include "validation/diagnosis/maths/span.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

TEST(Span, OfColumnsOfWhichOneIsZeroLeavesWhatTheOtherDoesNotReach) {
  Eigen::MatrixXd columns(3, 2);
  columns << 0, 2, 0, 0, 0, 0;
  const Eigen::VectorXd left = without(orthonormal(columns), Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(left.isApprox(Eigen::Vector3d(0, 2, 3)));
}

// Least squares by QR divided by zero here: a stop out of reach was worth no number.
TEST(Span, OfZerosReachesNothing) {
  const Eigen::MatrixXd zeros = Eigen::MatrixXd::Zero(3, 2);
  EXPECT_EQ(orthonormal(zeros).cols(), 0);
  EXPECT_EQ(without(orthonormal(zeros), Eigen::Vector3d(1, 2, 3)), Eigen::Vector3d(1, 2, 3));
}

}  // namespace
}  // namespace nao::validation
