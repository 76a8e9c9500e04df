#include "validation/diagnosis/beat_search.h"

#include <gtest/gtest.h>

#include "tests/validation/diagnosis/toy_joint.h"
#include "validation/diagnosis/joint_data.h"

namespace nao::validation {
namespace {

Effort few() {
  Effort effort;
  effort.look_runs = 2;
  effort.base_runs = 12;
  return effort;
}

// A hold beside commands of nearly its own rate: nothing but its own beat, met to a part of a turn
// over 6 s, shows it.
TEST(BeatSearch, MeetsAHoldsBeat) {
  constexpr double kHold = 0.0094;
  test::ToyLaws laws;
  laws.hold = kHold;
  laws.sent = 0.01;
  const test::ToyJoint toy(laws, 1, test::kToyNoise, 6, 3);
  std::vector<Cause> causes;
  for (Cause cause : test::toyCauses()) {
    if (cause.id == "command_hold") causes.push_back(boundedAt(cause, toy, sim::standardEffects()));
  }
  ASSERT_EQ(causes.size(), 1u);
  const JointData data(toy, test::kToyNoise);
  Ensemble ensemble(toy, data, test::kToyNoise, 1000000);
  const Stage stage(ensemble, data, causes, {}, Eigen::MatrixXd(data.size(), 0), few());
  const std::vector<double> sizes = beatingSizes(ensemble, stage, causes, 0);
  ASSERT_FALSE(sizes.empty());
  EXPECT_NEAR(sizes.front(), kHold, 2 * beatWidth(data, kHold));  // as far as a fit walks from it
}

}  // namespace
}  // namespace nao::validation
