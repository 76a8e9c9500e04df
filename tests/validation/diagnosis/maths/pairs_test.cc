#include "validation/diagnosis/maths/pairs.h"

#include <gtest/gtest.h>

namespace nao::validation {
namespace {

// Alone the third explains most of the residual, beside it neither of the others much; together
// these explain all.
TEST(Pairs, ExplainWhatNoneOfThemExplainsAlone) {
  const Eigen::Vector3d a(1, 0, 0), b(0, 1, 0), imitation(1, 1, 0.3);
  const std::vector<PairPart> parts = {{a, -5, 5}, {b, -5, 5}, {imitation, -5, 5}};
  const std::vector<PartPair> pairs = pairsOf(parts, Eigen::Vector3d(2, 3, 0));
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[0].first, 0u);
  EXPECT_EQ(pairs[0].second, 1u);
  EXPECT_NEAR(pairs[0].first_scale, 2, 1e-9);
  EXPECT_NEAR(pairs[0].second_scale, 3, 1e-9);
  EXPECT_NEAR(pairs[0].left, 0, 1e-12);
  EXPECT_GT(pairs[1].left, 0.01);
}

TEST(Pairs, StayWithinWhatWasSeen) {
  const std::vector<PairPart> parts = {{Eigen::Vector2d(1, 0), -1, 1},
                                       {Eigen::Vector2d(1, 1), 0.5, 1.5}};
  const std::vector<PartPair> pairs = pairsOf(parts, Eigen::Vector2d(4, 0));
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_DOUBLE_EQ(pairs[0].first_scale, 1);
  EXPECT_DOUBLE_EQ(pairs[0].second_scale, 1.5);
  EXPECT_DOUBLE_EQ(pairs[0].left, (1.5 * 1.5 + 1.5 * 1.5) / 2);
}

TEST(Pairs, LeaveOutWhatDoesNothing) {
  const std::vector<PairPart> parts = {{Eigen::Vector2d(1, 0), -1, 1},
                                       {Eigen::Vector2d(0, 0), -1, 1}};
  EXPECT_TRUE(pairsOf(parts, Eigen::Vector2d(1, 1)).empty());
}

}  // namespace
}  // namespace nao::validation
