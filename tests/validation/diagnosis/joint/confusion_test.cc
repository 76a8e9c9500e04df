#include "validation/diagnosis/joint/confusion.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/random.h"

namespace nao::validation {
namespace {

constexpr Eigen::Index kRows = 400;

Eigen::VectorXd drawn(Random& random) {
  Eigen::VectorXd x(kRows);
  for (double& one : x) one = random.normal();
  return x;
}

std::vector<Eigen::VectorXd> nulls(Random& random) {
  std::vector<Eigen::VectorXd> all;
  for (int i = 0; i < 300; ++i) all.push_back(drawn(random));
  return all;
}

Fitted without_chance(const std::string& cause, const Eigen::VectorXd& white) {
  return {cause, {white, white}};
}

// Two effects of length 4 whose angle has cosine c are told apart by the noise along their
// difference: the wrong one wins where that exceeds half its length, P(z > 4 sqrt((1 - c) / 2)).
TEST(Confusion, GrowsAsCausesGrowAlike) {
  Random random(1, "confusion");
  Eigen::VectorXd a = drawn(random), b = drawn(random);
  a *= 4 / a.norm();
  b -= a * a.dot(b) / a.squaredNorm();
  b *= 4 / b.norm();
  const std::vector<Eigen::VectorXd> noise = nulls(random);
  const Confusion apart = confusionOf({without_chance("a", a), without_chance("b", b)}, noise);
  EXPECT_EQ(apart.causes, (std::vector<std::string>{"a", "b"}));
  EXPECT_NEAR(apart.share[0][1], 0.002, 0.012);  // P(z > 2.83)
  const double cosine = 0.95;
  const Eigen::VectorXd alike = cosine * a + std::sqrt(1 - cosine * cosine) * b;
  const Confusion near = confusionOf({without_chance("a", a), without_chance("b", alike)}, noise);
  // P(z > 0.63) = 0.26, of 300 sets give or take 0.025.
  EXPECT_NEAR(near.share[0][1], 0.26, 0.075);
  EXPECT_NEAR(near.share[0][0] + near.share[0][1], 1, 1e-9);
}

TEST(Confusion, OfOneCandidateIsNone) {
  Random random(2, "confusion");
  const Eigen::VectorXd a = drawn(random);
  const Confusion one = confusionOf({without_chance("a", a)}, nulls(random));
  EXPECT_NEAR(one.share[0][0], 1, 1e-9);
}

}  // namespace
}  // namespace nao::validation
