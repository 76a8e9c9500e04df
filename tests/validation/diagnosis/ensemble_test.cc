#include "validation/diagnosis/ensemble.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/joint_data.h"

namespace nao::validation {
namespace {

// Two motions of two and one rows, four runs each.
TEST(RunPool, HalvesAreOfEvenAndOfOddStreamsAndMakeTheMean) {
  Eigen::MatrixXd longer(2, 4), shorter(1, 4);
  longer << 1, 2, 3, 6, 10, 20, 30, 60;
  shorter << 5, -1, 7, -3;
  RunPool pool{{longer, shorter}, Eigen::Vector3d(3, 30, 2)};
  const Halves halves = pool.halves();
  EXPECT_EQ(halves.first, Eigen::Vector3d(2, 20, 6));
  EXPECT_EQ(halves.second, Eigen::Vector3d(4, 40, -2));
  EXPECT_EQ(halves.mean(), pool.mean);
}

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

// A mean of R runs beside one of N others: 1 / R + 1 / N, however many repeats there are.
TEST(RunPool, ASetMeasuredAgainVariesAsMuchAsOneThatIs) {
  for (const int repeats : {6, 38, 39, 48, 90}) {
    const test::ToyJoint toy({}, 1, test::kToyNoise, repeats, 2);
    const JointData data(toy, test::kToyNoise);
    const RunPool pool = poolOf(data);
    double square = 0;
    for (std::uint64_t set = 1; set <= 50; ++set) {
      square += pool.measuredAgain(data, set).squaredNorm() / static_cast<double>(data.size()) / 50;
    }
    // 50 sets of 1200 samples know it to 1 %, those of 48 runs, which they share, to 1.2 %.
    EXPECT_NEAR(square, 1.0 / repeats + 1.0 / 48, 0.05 * (1.0 / repeats + 1.0 / 48)) << repeats;
  }
}

// A link heavier by 0.2 % moves the joint by a sixteenth of a count RMS: 8 rounded runs show mostly
// which readings happened to flip.
TEST(Ensemble, ShowsWhatASmallDifferenceDoesBeforeItIsRounded) {
  const JointNoise still{0.003, 0.05, 0.001, 0.0015};
  const test::ToyJoint toy({}, 1, still);
  const JointData data(toy, still);
  Ensemble ensemble(toy, data, still, 10000);
  const std::vector<EffectSetting> heavier{{"link_mass", {{"part", 0.002}}, {}, ""}};
  const Halves rounded = ensemble.roughHalves(heavier, 8) - ensemble.roughHalves({}, 8);
  const Halves real = ensemble.unroundedHalves(heavier, 8) - ensemble.unroundedHalves({}, 8);
  EXPECT_LT(rounded.coherence(), 0.7);
  EXPECT_GT(real.coherence(), 0.99);
}

}  // namespace
}  // namespace nao::validation
