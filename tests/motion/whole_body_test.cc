#include "motion/whole_body.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

constexpr double kFeet = 0.0001;  // [m]

class WholeBodyTest : public testing::Test {
 protected:
  WholeBodyTest() : bench(loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33")) {
    bench.pose("StandInit");
  }
  const Kinematics& body() {
    kinematics_.update(bench.engine.state().command.angle);
    return kinematics_;
  }
  Pose feetApart() { return body().calcSole(Foot::Left).inverse() * body().calcSole(Foot::Right); }
  // How deep the centre of mass is inside the support [m].
  double depth(Feet feet) {
    const Foot foot = feet == Feet::Right ? Foot::Right : Foot::Left;
    const Vec3 com = body().calcSole(foot).inverse() * body().calcCom();
    return depthIn(calcSupport(body(), feet), com.head<2>());
  }
  void standInBalance() {
    bench.post(WbEnable{true});
    bench.post(WbFootState{FootState::Fixed, Feet::Both});
    bench.post(WbBalance{true, Feet::Both});
  }

  EngineBench bench;

 private:
  Kinematics kinematics_{bench.model};
};

TEST_F(WholeBodyTest, DoesNothingUnlessSomethingIsAsked) {
  const JointArray<double> before = bench.engine.state().command.angle;
  standInBalance();
  bench.run(1);
  const JointArray<double> after = bench.engine.state().command.angle;
  for (std::size_t i = 0; i < after.size(); ++i) EXPECT_NEAR(after[i], before[i], 0.002) << i;
}

TEST_F(WholeBodyTest, TheCentreOfMassStaysInsideAndTheFeetStayWhileTheBodyIsDraggedForward) {
  for (const bool balanced : {false, true}) {
    bench.pose("StandInit");
    bench.post(WbEnable{balanced});
    if (balanced) standInBalance();
    const Pose feet = feetApart();
    // The ankles lean far forward, and one hip rolls.
    SetAngles lean;
    for (const char* name : {"LAnklePitch", "RAnklePitch", "LHipRoll"}) {
      lean.joints.push_back(bench.joint(name));
    }
    lean.angles = {-0.75, -0.75, 0.1};
    lean.fraction.assign(3, 0.05);
    bench.post(lean);
    double shallowest = 1;
    double slip = 0;
    for (int i = 0; i < 200; ++i) {
      bench.cycle();
      shallowest = std::min(shallowest, depth(Feet::Both));
      slip = std::max(slip, (feetApart().translation() - feet.translation()).norm());
    }
    if (!balanced) {
      EXPECT_LT(shallowest, 0.012);  // the motion needs the balancer
      EXPECT_GT(slip, kFeet);
      continue;
    }
    EXPECT_GT(shallowest, 0.0149);  // the margin of 15 mm
    EXPECT_LT(slip, kFeet);
  }
}

TEST_F(WholeBodyTest, AnArmUnderControlReachesWhereItsChainAloneCanNotInBalance) {
  const Effector hand = *findEffector(*bench.model, "LArm");
  bench.post(WbEffector{"LArm", true});
  bench.cycle();
  const Pose X_SR = body().calcSole(Foot::Left).inverse() * body().calcRobotFrame();
  const Pose X_SH = body().calcSole(Foot::Left).inverse() * body().calcPose(hand);
  const Vec3 start = X_SR.inverse() * X_SH.translation();
  const Vec3 target = start + Vec3(0.05, 0.03, -0.10);
  const Pose feet = feetApart();
  bench.post(WbEffectorTarget{"LArm", target});
  double shallowest = 1;
  double slip = 0;
  for (int i = 0; i < 400; ++i) {
    bench.cycle();
    shallowest = std::min(shallowest, depth(Feet::Both));
    slip = std::max(slip, (feetApart().translation() - feet.translation()).norm());
  }
  const Vec3 end = X_SR.inverse() *
                   (body().calcSole(Foot::Left).inverse() * body().calcPose(hand)).translation();
  EXPECT_NEAR((end - target).norm(), 0, 0.001);
  EXPECT_GT(shallowest, 0.0149);
  EXPECT_LT(slip, kFeet);
}

TEST_F(WholeBodyTest, TheHeadUnderControlTurnsWithTheBodysHelp) {
  bench.post(WbEffector{"Head", true});
  bench.post(WbEffectorTarget{"Head", Vec3(0.15, 0, 0)});  // no neck can roll
  bench.run(4);
  const Pose X_RT = body().calcRobotFrame().inverse();
  const Pose X_RH = X_RT * body().calcPose(*findEffector(*bench.model, "Head"));
  EXPECT_NEAR(rpyOf(X_RH.linear()).x(), 0.15, 0.01);
  bench.post(WbEffector{"Head", false});
  bench.cycle();
}

TEST_F(WholeBodyTest, GoToBalanceEndsOverTheMiddleOfTheFootInItsTime) {
  for (const Feet feet : {Feet::Left, Feet::Right, Feet::Both}) {
    const Pose apart = feetApart();
    const RequestId id = bench.post(WbGoToBalance{feet, 1.5});
    EXPECT_NEAR(bench.cyclesUntilEnd(id), 151, 2);
    const Foot foot = feet == Feet::Right ? Foot::Right : Foot::Left;
    const Vec3 com = body().calcSole(foot).inverse() * body().calcCom();
    EXPECT_NEAR((com.head<2>() - centreOf(calcSupport(body(), feet))).norm(), 0, 0.001);
    EXPECT_NEAR((feetApart().translation() - apart.translation()).norm(), 0, kFeet);
  }
}

TEST_F(WholeBodyTest, AFreeFootLiftsAndTheBodyBalancesOverTheOther) {
  standInBalance();
  bench.cyclesUntilEnd(bench.post(WbGoToBalance{Feet::Left, 2}));
  bench.post(WbBalance{true, Feet::Left});
  bench.post(WbFootState{FootState::Free, Feet::Right});
  const Pose before = feetApart();
  PoseTrack kick{"RLeg", Space::Robot, kMaskAll, {translation(Vec3(-0.05, 0, 0.04))}, {1.0}};
  const RequestId id = bench.post(InterpolatePoses{{kick}, true});
  double shallowest = 1;
  for (int i = 0; i < 250 && !bench.findOutcome(id); ++i) {
    bench.cycle();
    shallowest = std::min(shallowest, depth(Feet::Left));
  }
  ASSERT_NE(bench.findOutcome(id), nullptr);
  EXPECT_GT(shallowest, 0.0149);
  const Vec3 moved = feetApart().translation() - before.translation();
  // On its way the ankle's roll runs out of what its pitch leaves it.
  EXPECT_NEAR((moved - Vec3(-0.05, 0, 0.04)).norm(), 0, 0.001);
  const Mat3 turn = before.linear().transpose() * feetApart().linear();
  EXPECT_NEAR(Eigen::AngleAxisd(turn).angle(), 0, 0.003);
}

TEST(SupportPolygon, HullShrinkAndCentreOfASquare) {
  const Polygon square = calcHull({{0, 0}, {1, 0}, {0.5, 0.5}, {1, 1}, {0, 1}, {0.5, 0}});
  ASSERT_EQ(square.size(), 4u);
  EXPECT_NEAR((centreOf(square) - Eigen::Vector2d(0.5, 0.5)).norm(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(depthIn(square, {0.2, 0.5}), 0.2);
  EXPECT_LT(depthIn(square, {-0.2, 0.5}), 0);
  const Polygon inner = shrink(square, 0.25);
  EXPECT_NEAR(depthIn(inner, {0.5, 0.5}), 0.25, 1e-12);
  EXPECT_TRUE(shrink(square, 0.6).empty());
}

}  // namespace
}  // namespace nao::motion
