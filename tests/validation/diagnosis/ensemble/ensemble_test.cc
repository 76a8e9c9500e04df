#include "validation/diagnosis/ensemble/ensemble.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/ensemble/joint_data.h"

namespace nao::validation {
namespace {

// 48 runs of independent samples of variance 1.
RunPool poolOf(const JointData& data) {
  Random random(7, "pool");
  RunPool pool;
  pool.mean.resize(data.size());
  for (const MotionSpan& span : data.spans()) {
    Eigen::MatrixXd runs(span.size(), 48);
    for (double& value : runs.reshaped()) value = random.normal();
    pool.mean.segment(span.offset, span.size()) = runs.rowwise().mean();
    pool.runs.push_back(std::move(runs));
  }
  return pool;
}

// Of a sample, over 50 sets measured again.
double varianceAgain(const RunPool& pool, const JointData& data) {
  double square = 0;
  for (std::uint64_t set = 1; set <= 50; ++set) {
    square += pool.measuredAgain(data, set).squaredNorm() / static_cast<double>(data.size()) / 50;
  }
  return square;
}

// A mean of R runs beside one of N others: 1 / R + 1 / N, however many repeats there are.
TEST(RunPool, ASetMeasuredAgainVariesAsMuchAsOneThatIs) {
  for (const int repeats : {6, 38, 39, 48, 90}) {
    const test::ToyJoint toy({}, 1, test::kToyNoise, repeats, 2);
    const JointData data(toy, test::kToyNoise);
    const RunPool pool = poolOf(data);
    const double square = varianceAgain(pool, data);
    // 50 sets of 1200 samples know it to 1 %, those of 48 runs, which they share, to 1.2 %.
    EXPECT_NEAR(square, 1.0 / repeats + 1.0 / 48, 0.05 * (1.0 / repeats + 1.0 / 48)) << repeats;
  }
}

// What of their chance mirrors itself falls out of their mean: here nine tenths of the variance.
RunPool mirroredPoolOf(const JointData& data) {
  RunPool pool = poolOf(data);
  pool.mirrored = true;
  pool.pairing = 0.1;
  Random random(8, "pairs");
  for (std::size_t i = 0; i < pool.runs.size(); ++i) {
    Eigen::MatrixXd& runs = pool.runs[i];
    for (Eigen::Index r = 0; r < runs.cols(); r += r % 4 == 1 ? 3 : 1) {
      for (Eigen::Index k = 0; k < runs.rows(); ++k) {
        const double odd = std::sqrt(0.9) * random.normal();
        runs(k, r) = std::sqrt(0.1) * runs(k, r) + odd;
        runs(k, r + 2) = std::sqrt(0.1) * runs(k, r + 2) - odd;
      }
    }
    const MotionSpan& span = data.spans()[i];
    pool.mean.segment(span.offset, span.size()) = runs.rowwise().mean();
  }
  return pool;
}

TEST(RunPool, RunsThatMirrorEachOtherKnowTheirMeanBetter) {
  for (const int repeats : {6, 38}) {
    const test::ToyJoint toy({}, 1, test::kToyNoise, repeats, 2);
    const JointData data(toy, test::kToyNoise);
    const RunPool pool = mirroredPoolOf(data);
    const double square = varianceAgain(pool, data);
    const double expected = 1.0 / repeats + 0.1 / 48;
    EXPECT_NEAR(square, expected, 0.05 * expected) << repeats;
    EXPECT_NEAR(pool.worth(), 480, 1e-9);
    const Eigen::MatrixXd deviations = pool.deviations(0);
    EXPECT_NEAR(deviations.squaredNorm() / static_cast<double>(deviations.size()), 1, 0.05);
  }
}

// A link heavier by 0.2 % moves the joint by a sixteenth of a count RMS: 8 rounded runs show mostly
// which readings happened to flip.
class SmallDifference : public ::testing::Test {
 protected:
  double coherenceBeside(const std::vector<EffectSetting>& others) {
    std::vector<EffectSetting> heavier = others;
    heavier.push_back({"link_mass", {{"part", 0.002}}, {}, ""});
    return (ensemble_.roughHalves(heavier, 8) - ensemble_.roughHalves(others, 8)).coherence();
  }

 private:
  const JointNoise still_{0.003, 0.05, 0.001, 0.0015};
  const test::ToyJoint toy_{{}, 1, still_};
  const JointData data_{toy_, still_};
  Ensemble ensemble_{toy_, data_, still_, 10000};
};

TEST_F(SmallDifference, IsSeenBeforeItIsRounded) { EXPECT_GT(coherenceBeside({}), 0.99); }

TEST_F(SmallDifference, IsRoundedBesideACauseThatRounds) {
  EXPECT_LT(coherenceBeside({{"encoder_quantum", {{"quantum", 0.003}}, {}, ""}}), 0.7);
}

}  // namespace
}  // namespace nao::validation
