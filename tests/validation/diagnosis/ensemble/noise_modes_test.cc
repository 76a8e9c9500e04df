#include "validation/diagnosis/ensemble/noise_modes.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/ensemble/joint_data.h"
#include "validation/diagnosis/maths/whitening.h"

namespace nao::validation {
namespace {

constexpr int kRuns = 96;
constexpr Eigen::Index kHold = 100;  // rows of the first motion that are high or low as one

// Runs whose samples are independent, but for a hold that a whole run has `together` SDs too high.
RunPool poolOf(const JointData& data, double together) {
  Random random(3, "noise modes");
  RunPool pool;
  pool.mean = Eigen::VectorXd::Zero(data.size());
  for (const MotionSpan& span : data.spans()) {
    const Eigen::VectorXd sd =
        data.sd().segment(span.offset, span.size()) * std::sqrt(double(span.repeats));
    Eigen::MatrixXd runs(span.size(), kRuns);
    for (Eigen::Index r = 0; r < kRuns; ++r) {
      const double shift = span.offset == 0 ? together * random.normal() : 0;
      for (Eigen::Index i = 0; i < span.size(); ++i) {
        runs(i, r) = sd[i] * (random.normal() + (i < kHold ? shift : 0));
      }
    }
    pool.mean.segment(span.offset, span.size()) = runs.rowwise().mean();
    pool.runs.push_back(std::move(runs));
  }
  return pool;
}

// Of a hundred sets measured again: variance of the first hold's mean, times its rows.
double varianceOfHold(const RunPool& pool, const JointData& data, const Whitening& whiten) {
  double square = 0;
  for (std::uint64_t set = 1; set <= 100; ++set) {
    const double sum = whiten(pool.measuredAgain(data, set)).head(kHold).sum();
    square += sum * sum / kHold / 100;
  }
  return square;
}

TEST(NoiseModes, AHoldThatVariesAsOneIsOne) {
  const test::ToyJoint toy({}, 1);
  const JointData data(toy, test::kToyNoise);
  const RunPool pool = poolOf(data, 2);
  const NoiseModes modes = findNoiseModes(pool, kRuns, data, data.sd());
  ASSERT_EQ(modes.directions.cols(), 1);
  const Eigen::VectorXd mode = modes.directions.col(0).cwiseAbs();
  EXPECT_GT(mode.head(kHold).squaredNorm(), 0.95 * mode.squaredNorm());
  // As white samples it would vary by 1 + 100 * 2^2; a hundred sets know a variance to 14 %.
  EXPECT_GT(varianceOfHold(pool, data, Whitening(data.sd(), {})), 200);
  const double white = varianceOfHold(pool, data, Whitening(modes.sd, modes.directions));
  EXPECT_GT(white, 0.6);
  EXPECT_LT(white, 1.6);
}

TEST(NoiseModes, IndependentSamplesHaveNone) {
  const test::ToyJoint toy({}, 1);
  const JointData data(toy, test::kToyNoise);
  const NoiseModes modes = findNoiseModes(poolOf(data, 0), kRuns, data, data.sd());
  EXPECT_EQ(modes.directions.cols(), 0);
  EXPECT_LT(modes.sd.sum(), 1.1 * data.sd().sum());
}

}  // namespace
}  // namespace nao::validation
