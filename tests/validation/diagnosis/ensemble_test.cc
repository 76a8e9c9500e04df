#include "validation/diagnosis/ensemble.h"

#include <gtest/gtest.h>

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

TEST(Ensemble, WhatWasAskedBeforeCostsNothingWhileTheNoiseIsTheSame) {
  const test::ToyJoint joint(test::ToyLaws(), 1);
  const JointData data(joint, test::kToyNoise);
  Ensemble ensemble(joint, data, test::kToyNoise, 1000000);
  const std::vector<EffectSetting> gain = {{"kp_error", {{"part", 0.1}}, {}, ""}};
  const Halves first = ensemble.halves(gain, 4);
  const long used = ensemble.used();
  EXPECT_EQ(ensemble.halves(gain, 4).first, first.first);
  EXPECT_EQ(ensemble.used(), used);
  EXPECT_NE(ensemble.halves({}, 4).first, first.first);
  JointNoise other = test::kToyNoise;
  other.torque_sd *= 2;
  ensemble.setNoise(other);
  EXPECT_NE(ensemble.halves(gain, 4).first, first.first);
  EXPECT_GT(ensemble.used(), used);
}

}  // namespace
}  // namespace nao::validation
