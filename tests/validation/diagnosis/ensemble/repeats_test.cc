#include "validation/diagnosis/ensemble/repeats.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/ensemble/joint_data.h"

namespace nao::validation {
namespace {

// Repeats of noise with SD 2 whose samples are correlated as keep^lag.
JointMotion noisy(double keep, int repeats) {
  Random random(5, "repeats");
  JointMotion motion{"noise", Split::Fit, 0.01, {}};
  for (int r = 0; r < repeats; ++r) {
    Eigen::MatrixXd run(1000, 1);
    double x = random.normal();
    for (int i = 0; i < 1000; ++i) {
      run(i, 0) = 2 * x;
      x = keep * x + std::sqrt(1 - keep * keep) * random.normal();
    }
    motion.repeats.push_back(run);
  }
  return motion;
}

TEST(Repeats, TellTheSdOfOneRun) { EXPECT_NEAR(statisticsOf(noisy(0.8, 8)).sd.mean(), 2, 0.1); }

TEST(Repeats, TellHowManySamplesAreWorthOne) {
  // 1 + 2 (k + k^2 + ...) = (1 + k) / (1 - k) = 9 for k = 0.8.
  EXPECT_NEAR(statisticsOf(noisy(0.8, 8)).inflation[0], 9, 1.5);
  EXPECT_NEAR(statisticsOf(noisy(0, 8)).inflation[0], 1, 0.2);
}

// Repeats of one swing that begin 2 ms early or late, with noise of SD 1e-4.
TEST(Repeats, LatenessIsNotNoise) {
  Random random(7, "late");
  JointMotion motion{"swing", Split::Fit, 0.01, {}};
  for (const double late : {-0.002, 0.002, -0.001, 0.0015, 0.0005, -0.001}) {
    Eigen::MatrixXd run(600, 1);
    for (int i = 0; i < 600; ++i) {
      run(i, 0) = std::sin(4 * (0.01 * i - late)) + 1e-4 * random.normal();
    }
    motion.repeats.push_back(run);
  }
  const RepeatStatistics found = statisticsOf(motion);
  EXPECT_NEAR(found.sd.mean(), 1e-4, 2e-5);  // 4e-3 with the lateness
  const Eigen::VectorXd rate = rateOf(found.mean.col(0), 0.01);
  const double late = latenessOf(motion.repeats[1].col(0) - found.mean.col(0), rate);
  EXPECT_NEAR(late, 0.002, 1e-4);  // the mean is on time
}

TEST(Repeats, HalvesDifferByTheNoiseOfTheMean) {
  const JointMotion motion = noisy(0, 6);
  double square = 0;
  for (int split = 0; split < splitCount(6); ++split) {
    square += halfDifference(motion, split).squaredNorm() / 1000 / splitCount(6);
  }
  EXPECT_NEAR(square, 4.0 / 6, 0.05);
}

TEST(JointData, LeavesTestMotionsClosed) {
  test::ToyJoint toy({}, 1);
  const JointData all(toy, test::kToyNoise);
  EXPECT_EQ(all.spans().size(), 5u);
  EXPECT_EQ(all.size(), 5 * 600);
  EXPECT_EQ(all.blocks(), 5 * 6);
}

}  // namespace
}  // namespace nao::validation
