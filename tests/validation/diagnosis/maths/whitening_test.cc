#include "validation/diagnosis/maths/whitening.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace nao::validation {
namespace {

TEST(Whitening, MakesNoiseOfUnitVarianceWhateverTheDirections) {
  constexpr int kSize = 40, kDraws = 4000;
  Random random(3, "whitening");
  const auto draw = [&] { return random.normal(); };
  const Eigen::VectorXd sd = Eigen::VectorXd::LinSpaced(kSize, 0.5, 2);
  Eigen::MatrixXd directions(kSize, 2);
  for (int i = 0; i < kSize; ++i) directions.row(i) << 1, 0.2 * i;
  const Whitening whitening(sd, directions);
  Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(kSize, kSize);
  for (int n = 0; n < kDraws; ++n) {
    const Eigen::VectorXd noise = sd.cwiseProduct(Eigen::VectorXd::NullaryExpr(kSize, draw));
    const Eigen::VectorXd white =
        whitening(noise + directions * Eigen::VectorXd::NullaryExpr(2, draw));
    covariance += white * white.transpose() / kDraws;
  }
  // A covariance of n draws is known to sqrt(2 / n); the largest of 1600 entries to 4 of those.
  EXPECT_LT((covariance - Eigen::MatrixXd::Identity(kSize, kSize)).cwiseAbs().maxCoeff(),
            5 * std::sqrt(2.0 / kDraws));
}

}  // namespace
}  // namespace nao::validation
