#include "validation/diagnosis/ensemble/joint_data.h"

#include <gtest/gtest.h>

#include "tests/validation/diagnosis/toy_joint.h"

namespace nao::validation {
namespace {

// Runs that begin apart read a moving joint at other places between two counts, so that their mean
// hardly errs; where it rests they read the same. Null sets of legs that shake little were given
// the error of a joint at rest everywhere, four times what right models were off by, squared.
TEST(JointData, RoundingErrsLessWhereRunsThatBeginApartMove) {
  JointNoise noise = test::kToyNoise;
  noise.torque_sd = 0.001;
  const test::ToyJoint toy({}, 1, noise, 6, 2);
  noise.start_sd = 0;
  const JointData alike(toy, noise);
  noise.start_sd = 1.5e-3;
  const JointData apart(toy, noise);
  const double count = apart.quantum();
  const MotionSpan& span = apart.spans()[0];
  const Eigen::VectorXd rate = rateOf(apart.mean().head(span.rows), span.dt);
  int moving = 0, resting = 0;
  for (Eigen::Index i = 0; i < span.rows; ++i) {
    const double by = std::abs(rate[i]) * noise.start_sd / count;  // counts
    const double part = apart.rounding()[i] / alike.rounding()[i];
    if (by > 0.5) {
      EXPECT_LT(part, 0.35) << i;
    }
    if (by < 0.02) {
      EXPECT_GT(part, 0.98) << i;
    }
    moving += by > 0.5;
    resting += by < 0.02;
  }
  EXPECT_GT(moving, 20);
  EXPECT_GT(resting, 5);
}

}  // namespace
}  // namespace nao::validation
