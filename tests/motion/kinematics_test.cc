#include "motion/kinematics.h"

#include <gtest/gtest.h>

#include "tests/motion/biped.h"

namespace nao::motion {
namespace {

constexpr double kRounding = 1e-12;  // [m] sums of a few products of numbers near 1

TEST(Kinematics, PutsTheSolesOfStraightLegsBelowTheHips) {
  const Kinematics kinematics(test::makeBiped());
  const Vec3 left = kinematics.calcSole(Foot::Left).translation();
  EXPECT_NEAR((left - Vec3(0.005, 0.05, -0.33)).norm(), 0, kRounding);
  const Vec3 right = kinematics.calcSole(Foot::Right).translation();
  EXPECT_NEAR((right - Vec3(0.005, -0.05, -0.33)).norm(), 0, kRounding);
}

TEST(Kinematics, TurnsAboutTheHingeAxis) {
  const auto model = test::makeBiped();
  Kinematics kinematics(model);
  JointArray<double> q(model->jointCount(), 0.0);
  q[*model->findJoint("LKneePitch")] = M_PI / 2;  // the shank swings back, to the horizontal
  kinematics.update(q);
  const Vec3 ankle = kinematics.getPose(*model->findBody("LAnkleRoll")).translation();
  EXPECT_NEAR((ankle - Vec3(0.005 - 0.1, 0.05, -0.18)).norm(), 0, kRounding);
}

TEST(Kinematics, TurnsBothYawPitchHingesWithOneMotorAsMirrorImages) {
  const auto model = test::makeBiped();
  Kinematics kinematics(model);
  JointArray<double> q(model->jointCount(), 0.0);
  q[*model->findJoint("LHipYawPitch")] = -0.4;  // toes out
  kinematics.update(q);
  const Pose left = kinematics.calcSole(Foot::Left);
  const Pose right = kinematics.calcSole(Foot::Right);
  EXPECT_GT(rpyOf(left.linear()).z(), 0.2);
  EXPECT_NEAR(rpyOf(left.linear()).z(), -rpyOf(right.linear()).z(), kRounding);
  EXPECT_NEAR(left.translation().y(), -right.translation().y(), kRounding);
  EXPECT_NEAR(left.translation().x(), right.translation().x(), kRounding);
}

TEST(Kinematics, WeighsTheCentreOfMassByMass) {
  const auto model = test::makeBiped();
  Kinematics kinematics(model);
  // By hand: 4 kg at z 0.05; per leg three links at the hip (-0.08), one at the knee (-0.18), two
  // at the ankle (-0.28); the knee and ankle links sit 5 mm forward.
  const double mass = 4 + 12 * 0.1;
  const double z = (4 * 0.05 + 2 * 0.1 * (3 * -0.08 - 0.18 + 2 * -0.28)) / mass;
  const double x = 2 * 0.1 * 3 * 0.005 / mass;
  EXPECT_NEAR((kinematics.calcCom() - Vec3(x, 0, z)).norm(), 0, kRounding);
}

TEST(Kinematics, KeepsTheRobotFrameOnTheFloorWhenAFootIsLifted) {
  const auto model = test::makeBiped();
  Kinematics kinematics(model);
  JointArray<double> q(model->jointCount(), 0.0);
  q[*model->findJoint("LHipPitch")] = -0.5;
  q[*model->findJoint("LKneePitch")] = 1.0;
  q[*model->findJoint("LAnklePitch")] = -0.5;
  kinematics.update(q);
  EXPECT_NEAR(kinematics.calcRobotFrame().translation().z(), -0.33, kRounding);
  EXPECT_NEAR(kinematics.calcRobotFrame().translation().y(), 0, kRounding);
}

TEST(Kinematics, FindsEffectorsByChainFrameBodyAndHinge) {
  const auto model = test::makeBiped();
  model->groups["Head"] = {"LHipYawPitch", "LHipRoll", "Grip"};  // "Grip" turns nothing
  model->frames.push_back({"LArm", 2, translation(Vec3(1, 2, 3))});
  EXPECT_EQ(findEffector(*model, "Torso")->body, 0);
  EXPECT_EQ(findEffector(*model, "LLeg")->body, model->feet[0].body);
  EXPECT_NEAR(findEffector(*model, "LLeg")->X_BF.translation().z(), -0.05, kRounding);
  EXPECT_EQ(findEffector(*model, "RLeg")->body, model->feet[1].body);
  EXPECT_EQ(findEffector(*model, "Head")->body, *model->findBody("LHipRoll"));
  EXPECT_EQ(findEffector(*model, "LArm")->X_BF.translation(), Vec3(1, 2, 3));
  EXPECT_EQ(findEffector(*model, "RKneePitch")->body, *model->findBody("RKneePitch"));
  EXPECT_FALSE(findEffector(*model, "Tail").has_value());
}

}  // namespace
}  // namespace nao::motion
