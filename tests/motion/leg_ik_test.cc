#include "motion/leg_ik.h"

#include <gtest/gtest.h>

#include "core/random.h"
#include "motion/kinematics.h"
#include "tests/motion/biped.h"

namespace nao::motion {
namespace {

constexpr double kExact = 1e-9;  // [m], [rad]: a dozen trigonometric functions of rounding 1e-16

double distance(const Pose& a, const Pose& b) {
  return (a.translation() - b.translation()).norm() +
         Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

class LegIkTest : public testing::Test {
 protected:
  // Angles a walking Nao has, and beyond; the knee clearly bent, so that one solution exists.
  JointArray<double> randomAngles() {
    JointArray<double> q(model_->jointCount(), 0.0);
    for (const char* name : {"HipRoll", "AnkleRoll"}) {
      q[joint("L", name)] = random_.uniform(-0.35, 0.35);
      q[joint("R", name)] = random_.uniform(-0.35, 0.35);
    }
    for (const char* side : {"L", "R"}) {
      q[joint(side, "HipPitch")] = random_.uniform(-1.4, 0.4);
      q[joint(side, "KneePitch")] = random_.uniform(0.2, 1.9);
      // Keeps the leg within 60 degrees of the sole's normal: the hip is above the foot.
      const double lean = random_.uniform(-1.0, 1.0);
      q[joint(side, "AnklePitch")] = lean - 0.5 * q[joint(side, "KneePitch")];
    }
    q[joint("L", "HipYawPitch")] = random_.uniform(-1.1, 0.7);
    return q;
  }
  Joint joint(const std::string& side, const std::string& name) const {
    return *model_->findJoint(side + name);
  }

  std::shared_ptr<RobotModel> model_ = test::makeBiped();
  LegIk ik_{model_};
  Kinematics kinematics_{model_};
  Random random_{7};
};

TEST_F(LegIkTest, FindsTheAnglesTheSolesWerePutWith) {
  for (int i = 0; i < 2000; ++i) {
    const JointArray<double> q = randomAngles();
    kinematics_.update(q);
    const LegSolution found =
        ik_.solve(kinematics_.calcSole(Foot::Left), kinematics_.calcSole(Foot::Right));
    ASSERT_TRUE(found.withinReach());
    JointArray<double> again(model_->jointCount(), 9.0);
    ik_.apply(found, again);
    for (std::size_t k = 0; k < q.size(); ++k) ASSERT_NEAR(again[k], q[k], kExact) << k;
  }
}

TEST_F(LegIkTest, KeepsPlaceAndSlopeOfBothSolesWhenTheirHeadingsDisagree) {
  const Pose left = translation(Vec3(0.01, 0.06, -0.3));
  Pose right = translation(Vec3(-0.01, -0.05, -0.29));
  right.linear() = rotationFromRpy(0.05, -0.1, 0.3);
  JointArray<double> q(model_->jointCount(), 0.0);
  ik_.apply(ik_.solve(left, right), q);
  kinematics_.update(q);
  const Pose got = kinematics_.calcSole(Foot::Right);
  EXPECT_NEAR((got.translation() - right.translation()).norm(), 0, kExact);
  EXPECT_NEAR((got.linear().col(2) - right.linear().col(2)).norm(), 0, kExact);
  EXPECT_GT(distance(got, right), 0.05);  // the heading had to give way
}

TEST_F(LegIkTest, KeepsTheHeadingOfTheFootWhoseShareIsOne) {
  const Pose left = translation(Vec3(0.01, 0.06, -0.3));
  Pose right = translation(Vec3(-0.01, -0.05, -0.29));
  right.linear() = rotationFromRpy(0, 0, 0.3);
  JointArray<double> q(model_->jointCount(), 0.0);
  ik_.apply(ik_.solve(left, right, 1), q);
  kinematics_.update(q);
  EXPECT_NEAR(distance(kinematics_.calcSole(Foot::Left), left), 0, kExact);
  ik_.apply(ik_.solve(left, right, 0), q);
  kinematics_.update(q);
  EXPECT_NEAR(distance(kinematics_.calcSole(Foot::Right), right), 0, kExact);
}

TEST_F(LegIkTest, LosesNothingWhenTheTorsoMayTurn) {
  for (int i = 0; i < 500; ++i) {
    Pose X_WT = translation(Vec3(0.01, 0, 0.3));
    X_WT.linear() = rotationFromRpy(random_.uniform(-0.1, 0.1), random_.uniform(-0.1, 0.1), 0);
    Pose X_WL = translation(Vec3(random_.uniform(-0.04, 0.04), 0.055, random_.uniform(0, 0.03)));
    X_WL.linear() = rotationFromRpy(0, random_.uniform(-0.1, 0.1), random_.uniform(-0.2, 0.3));
    Pose X_WR = translation(Vec3(random_.uniform(-0.04, 0.04), -0.055, 0));
    X_WR.linear() = rotationFromRpy(0, 0, random_.uniform(-0.3, 0.2));
    X_WT.linear() =
        Eigen::AngleAxisd(ik_.calcEqualYaw(X_WT, X_WL, X_WR), Vec3::UnitZ()) * X_WT.linear();
    const LegSolution found = ik_.solve(X_WT.inverse() * X_WL, X_WT.inverse() * X_WR);
    ASSERT_TRUE(found.withinReach());
    JointArray<double> q(model_->jointCount(), 0.0);
    ik_.apply(found, q);
    kinematics_.update(q);
    ASSERT_NEAR(distance(X_WT * kinematics_.calcSole(Foot::Left), X_WL), 0, kExact);
    ASSERT_NEAR(distance(X_WT * kinematics_.calcSole(Foot::Right), X_WR), 0, kExact);
  }
}

TEST_F(LegIkTest, StretchesTowardsASoleOutOfReachAndSaysSo) {
  const Pose near = translation(Vec3(0, 0.05, -0.3));
  const Pose far = translation(Vec3(0, -0.05, -0.5));
  const LegSolution found = ik_.solve(near, far);
  EXPECT_TRUE(found.reachable[0]);
  EXPECT_FALSE(found.reachable[1]);
  EXPECT_NEAR(found.angle[1][1], 0, kExact);    // straight down
  EXPECT_LT(std::abs(found.angle[1][3]), 0.1);  // the knee stretched (its links lean 3 degrees)
}

TEST_F(LegIkTest, ClampsToTheCommandRangeAndSaysSo) {
  model_->actuators[index(joint("L", "AnklePitch"))].lower = -0.3;
  const LegIk narrow(model_);
  const Pose squat = translation(Vec3(0, 0.05, -0.26));
  const LegSolution found = narrow.solve(squat, translation(Vec3(0, -0.05, -0.26)));
  EXPECT_FALSE(found.reachable[0]);
  EXPECT_TRUE(found.reachable[1]);
  EXPECT_DOUBLE_EQ(found.angle[0][4], -0.3);
}

TEST_F(LegIkTest, RefusesLegsOfAnotherKind) {
  EXPECT_TRUE(LegIk::fits(*model_));
  model_->bodies[2].axis = Vec3::UnitY();
  EXPECT_FALSE(LegIk::fits(*model_));
  EXPECT_THROW(LegIk{model_}, InputError);
}

}  // namespace
}  // namespace nao::motion
