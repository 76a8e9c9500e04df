#include "validation/diagnosis/maths/smaller_models.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

// Responses over 5 samples; the second and third are nearly opposite.
LinearCause servo() {
  return {(Eigen::MatrixXd(5, 1) << 10, 10, 0, 0, 0).finished(),
          Eigen::VectorXd::Constant(1, -0.4)};
}
LinearCause spring() {
  return {(Eigen::MatrixXd(5, 1) << 0, 0, 100, 100, 0).finished(),
          Eigen::VectorXd::Constant(1, 0.5)};
}
LinearCause bias() {
  return {(Eigen::MatrixXd(5, 1) << 0, 0, -100, -100, 2).finished(),
          Eigen::VectorXd::Constant(1, 0.5)};
}

const Eigen::VectorXd kNothingLeft = Eigen::VectorXd::Zero(5);

TEST(SmallerModels, FindsCausesThatOnlyCancelEachOther) {
  const auto found = smallerModels({servo(), spring(), bias()}, kNothingLeft, 5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].kept, std::vector<std::size_t>{0});
  EXPECT_NEAR(found[0].cost, 0.5, 1e-9);  // half the square of what is left of both: 2 * 0.5
  EXPECT_NEAR(found[0].numbers[0], -0.4, 1e-9);
}

TEST(SmallerModels, LeavesOutCausesThatAreNeeded) {
  LinearCause needed = spring();
  needed.numbers[0] = 1;
  EXPECT_TRUE(smallerModels({servo(), needed, bias()}, kNothingLeft, 5).empty());
}

TEST(SmallerModels, SaysNothingOfCausesWhoseResponseTellsNothing) {
  LinearCause rough = spring();
  rough.linear = false;
  EXPECT_TRUE(smallerModels({servo(), rough, bias()}, kNothingLeft, 5).empty());
}

TEST(SmallerModels, FitsWhatStaysToWhatIsLeft) {
  Eigen::VectorXd left = kNothingLeft;
  left[0] = left[1] = 1;
  const auto found = smallerModels({servo(), spring(), bias()}, left, 5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(found[0].numbers[0], -0.3, 1e-9);
}

TEST(SmallerModels, OfOneCauseThereIsNone) {
  EXPECT_TRUE(smallerModels({servo()}, kNothingLeft, 1e9).empty());
}

TEST(SmallerModels, TellsPairsThatUndoEachOtherWhateverTheyLeave) {
  LinearCause late = spring();
  late.linear = false;
  late.numbers[0] = 0.6;  // a sixth more than the bias takes back
  const auto pairs = undoneByEachOther({servo(), late, bias()});
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0], std::make_pair(std::size_t{1}, std::size_t{2}));
  late.numbers[0] = 1;
  EXPECT_TRUE(undoneByEachOther({servo(), late, bias()}).empty());
}

}  // namespace
}  // namespace nao::validation
