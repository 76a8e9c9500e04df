#include "validation/diagnosis/causes/model_slopes.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

double tenth(std::size_t) { return 0.1; }

TEST(OnlyOneOfInterest, IsTheOneWhoseNumberIsLargeEnough) {
  EXPECT_EQ(onlyOneOfInterest({{0, {0, 7}}, {1, {-0.3}}}, tenth), 1u);
  EXPECT_EQ(onlyOneOfInterest({{0, {0.2, 7}}}, tenth), 0u);
  EXPECT_EQ(onlyOneOfInterest({{0, {0.2, 7}}, {1, {-0.3}}}, tenth), std::nullopt);
  EXPECT_EQ(onlyOneOfInterest({{0, {0, 7}}, {1, {0.05}}}, tenth), std::nullopt);
}

TEST(OnlyOneOfInterest, AsksForTheSizeOfEachCause) {
  const auto smallest = [](std::size_t cause) { return cause == 4 ? 1 : 0.1; };
  EXPECT_EQ(onlyOneOfInterest({{4, {0.5}}, {3, {0.5}}}, smallest), 1u);
}

TEST(SizeOf, IsTheFirstNumberOfACauseWithItsSlope) {
  const ModelSlopes fit{
      {{1, {5}}, {0, {-0.3, 7}}}, Eigen::MatrixXd::Random(4, 3), Eigen::MatrixXd::Random(4, 3)};
  const ModelSlopes size = sizeOf(fit, 1);
  ASSERT_EQ(size.model.size(), 1u);
  EXPECT_EQ(size.model[0].cause, 0u);
  EXPECT_EQ(size.model[0].x, std::vector<double>{-0.3});
  EXPECT_EQ(size.jacobian, fit.jacobian.col(1));
  EXPECT_EQ(size.chance, fit.chance.col(1));
}

}  // namespace
}  // namespace nao::validation
