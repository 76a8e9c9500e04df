#include "walk_engine/balance.h"

#include <gtest/gtest.h>

#include "tests/support/models.h"

namespace nao::walk {
namespace {

class BalanceTest : public testing::Test {
 protected:
  /// By how much the joint turns when the torso turns like this.
  double turn(const char* joint, const Vec3& gyroscope, std::array<bool, 2> stands) const {
    JointArray<double> angle(model_->jointCount(), 0.0);
    Balance(*model_, tuning_).apply(gyroscope, stands, angle);
    return angle[*model_->findJoint(joint)];
  }

  std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33");
  Tuning tuning_;
};

const Vec3 kFallsRight{1, 0, 0};  // [rad/s]
const Vec3 kFallsForward{0, 1, 0};

TEST_F(BalanceTest, AnklesOfTheFeetThatStandPressAgainstTheFall) {
  EXPECT_DOUBLE_EQ(turn("LAnkleRoll", kFallsRight, {true, true}), tuning_.roll_damping);
  EXPECT_DOUBLE_EQ(turn("RAnklePitch", kFallsForward, {true, true}), tuning_.pitch_damping);
  EXPECT_EQ(turn("LAnkleRoll", kFallsRight, {false, true}), 0);
}

TEST_F(BalanceTest, TheCarryingHipLetsTheTorsoTurnWithAFallToTheSide) {
  EXPECT_DOUBLE_EQ(turn("LHipRoll", kFallsRight, {true, true}), -tuning_.hip_follow);
  EXPECT_EQ(turn("LHipRoll", kFallsRight, {false, true}), 0);
  EXPECT_EQ(turn("LHipRoll", kFallsForward, {true, true}), 0);
}

TEST_F(BalanceTest, NeverTurnsAJointFar) {
  EXPECT_LE(turn("LAnkleRoll", 100 * kFallsRight, {true, true}), 0.15);
  EXPECT_GE(turn("LHipRoll", 100 * kFallsRight, {true, true}), -0.15);
}

TEST_F(BalanceTest, TheOpenLoopDoesNotAnswer) {
  tuning_ = openLoop(tuning_);
  EXPECT_EQ(turn("LAnkleRoll", kFallsRight, {true, true}), 0);
  EXPECT_EQ(turn("LHipRoll", kFallsRight, {true, true}), 0);
}

}  // namespace
}  // namespace nao::walk
