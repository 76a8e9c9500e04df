#include "validation/diagnosis/joint/motion_votes.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace nao::validation {
namespace {

constexpr int kMotions = 4;

// Of `numbers` numbers, each vote with an SD of one.
Eigen::MatrixXd noise(Random& random, Eigen::Index numbers) {
  return Eigen::MatrixXd::NullaryExpr(kMotions, numbers, [&] { return random.normal(); });
}

std::vector<Eigen::MatrixXd> nulls(Eigen::Index numbers) {
  Random random(1, "nulls");
  std::vector<Eigen::MatrixXd> all;
  for (int n = 0; n < 200; ++n) all.push_back(noise(random, numbers));
  return all;
}

TEST(Disagreement, IsTheVarianceBeyondChance) {
  Eigen::MatrixXd votes(kMotions, 2);
  votes << 10, 0.1, -10, -0.1, 10, 0.1, -10, -0.1;
  const Eigen::VectorXd found = disagreement(votes, nulls(2));
  // Of a sum of four votes with squares of 100 about their mean: 4 / 3 * 400, less the chance's 4,
  // which 200 nulls of four votes tell to 4 * sqrt(2 / 3 / 200) = 0.23.
  EXPECT_NEAR(found[0], 4.0 / 3 * 400 - 4, 3 * 0.23);
  EXPECT_EQ(found[1], 0);  // less apart than by chance
}

TEST(Disagreement, OfOneMotionThereIsNone) {
  const Eigen::MatrixXd one = Eigen::MatrixXd::Constant(1, 1, 5);
  EXPECT_EQ(disagreement(one, {one})[0], 0);
}

}  // namespace
}  // namespace nao::validation
