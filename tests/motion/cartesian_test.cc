#include "motion/cartesian.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/pose_follower.h"
#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

constexpr double kReach = 0.001;     // [m] the bar for where a path ends
constexpr double kStraight = 0.001;  // [m] off the line
constexpr double kFeet = 0.0001;     // [m] the feet to each other, as commanded

class CartesianTest : public testing::Test {
 protected:
  CartesianTest() : bench(loadRobotModel(NAO_SOURCE_DIR "/robots", "nao_h21_v33")) {
    bench.pose("StandInit");
  }
  const Kinematics& body() {
    kinematics_.update(bench.engine.state().command.angle);
    return kinematics_;
  }
  Pose placeOf(const char* name, Space space) {
    const Pose X_TF = body().calcPose(*findEffector(*bench.model, name));
    return calcSpace(body(), space, {}).inverse() * X_TF;
  }
  Pose feetApart() { return body().calcSole(Foot::Left).inverse() * body().calcSole(Foot::Right); }
  static PoseTrack track(const char* chain, Space space, int mask, const Vec3& move,
                         double seconds) {
    return {chain, space, mask, {translation(move)}, {seconds}};
  }

  EngineBench bench;

 private:
  Kinematics kinematics_{bench.model};
};

TEST_F(CartesianTest, AnArmReachesItsPlaceOnAStraightLineInTime) {
  const Vec3 start = placeOf("LArm", Space::Torso).translation();
  const Vec3 way(0.03, 0.02, 0.05);
  const RequestId id =
      bench.post(InterpolatePoses{{track("LArm", Space::Torso, kMaskPosition, way, 1.0)}, true});
  double farthest = 0;
  for (int i = 0; i < 100; ++i) {
    bench.cycle();
    const Vec3 p = placeOf("LArm", Space::Torso).translation() - start;
    farthest = std::max(farthest, (p - p.dot(way) / way.squaredNorm() * way).norm());
  }
  EXPECT_NEAR((placeOf("LArm", Space::Torso).translation() - start - way).norm(), 0, kReach);
  EXPECT_LT(farthest, kStraight);
  bench.cycle();
  ASSERT_NE(bench.findOutcome(id), nullptr);
}

TEST_F(CartesianTest, AnAbsolutePlaceInTheRobotFrameIsTheOneGetPositionTells) {
  const Pose goal = translation(placeOf("RArm", Space::Robot).translation() + Vec3(0.02, 0, 0.03));
  PoseTrack arm{"RArm", Space::Robot, kMaskPosition, {goal}, {0.8}};
  bench.post(InterpolatePoses{{arm}, false});
  bench.run(1);
  EXPECT_NEAR((placeOf("RArm", Space::Robot).translation() - goal.translation()).norm(), 0, kReach);
}

TEST_F(CartesianTest, TheTorsoMovesOverFeetThatStay) {
  const Pose feet = feetApart();
  const Vec3 start = placeOf("Torso", Space::Robot).translation();
  const Vec3 way(0.01, -0.04, -0.03);
  bench.post(InterpolatePoses{{track("Torso", Space::Robot, kMaskAll, way, 2.0)}, true});
  double slip = 0;
  for (int i = 0; i < 200; ++i) {
    bench.cycle();
    slip = std::max(slip, (feetApart().translation() - feet.translation()).norm());
  }
  EXPECT_LT(slip, kFeet);
  EXPECT_NEAR((placeOf("Torso", Space::Robot).translation() - start - way).norm(), 0, kReach);
}

TEST_F(CartesianTest, ALegMovesOverTheOtherThatStays) {
  const Pose before = body().calcSole(Foot::Right).inverse() * body().calcSole(Foot::Left);
  const Pose X_RT = body().calcSole(Foot::Right).inverse();
  const Vec3 way(0.02, 0.03, 0.04);
  bench.post(InterpolatePoses{{track("LLeg", Space::Robot, kMaskAll, way, 1.5)}, true});
  bench.run(1.6);
  const Pose after = body().calcSole(Foot::Right).inverse() * body().calcSole(Foot::Left);
  EXPECT_NEAR((after.translation() - before.translation() - way).norm(), 0, kReach);
  EXPECT_LT(Eigen::AngleAxisd(after.linear() * before.linear().transpose()).angle(), 0.003);
  EXPECT_LT((body().calcSole(Foot::Right).inverse().translation() - X_RT.translation()).norm(),
            0.005);  // the torso stays as well as eleven motors can
}

TEST_F(CartesianTest, AWayThroughSeveralPosesPassesThemInTime) {
  const Vec3 start = placeOf("LArm", Space::Torso).translation();
  PoseTrack arm = track("LArm", Space::Torso, kMaskPosition, Vec3(0.03, 0, 0.03), 0.6);
  arm.path.push_back(translation(Vec3(0, 0.02, 0.05)));
  arm.times.push_back(1.2);
  bench.post(InterpolatePoses{{arm}, true});
  bench.run(0.6);
  EXPECT_NEAR((placeOf("LArm", Space::Torso).translation() - start - Vec3(0.03, 0, 0.03)).norm(), 0,
              kReach);
  bench.run(0.6);
  EXPECT_NEAR((placeOf("LArm", Space::Torso).translation() - start - Vec3(0, 0.02, 0.05)).norm(), 0,
              kReach);
}

TEST_F(CartesianTest, OutOfReachEndsWithinASecondAfterItsTimeAndInsideTheRanges) {
  const RequestId id = bench.post(
      InterpolatePoses{{track("LArm", Space::Torso, kMaskPosition, Vec3(1, 1, 1), 0.5)}, true});
  const int cycles = bench.cyclesUntilEnd(id, 200);
  EXPECT_GT(cycles, 49);
  EXPECT_LE(cycles, 152);
  const JointArray<double> angle = bench.engine.state().command.angle;
  for (std::size_t i = 0; i < angle.size(); ++i) {
    EXPECT_GE(angle[i], bench.model->actuators[i].lower - 1e-9);
    EXPECT_LE(angle[i], bench.model->actuators[i].upper + 1e-9);
  }
}

TEST_F(CartesianTest, ASecondMotionOfTheSameArmWaits) {
  const Vec3 up(0, 0, 0.02);
  bench.post(InterpolatePoses{{track("LArm", Space::Torso, kMaskPosition, up, 0.5)}, true});
  const RequestId second =
      bench.post(InterpolatePoses{{track("LArm", Space::Torso, kMaskPosition, up, 0.5)}, true});
  EXPECT_NEAR(bench.cyclesUntilEnd(second), 101, 3);
}

TEST_F(CartesianTest, SetPositionEndsAtOnceAndArrivesNoFasterThanItsFraction) {
  const Vec3 start = placeOf("LArm", Space::Torso).translation();
  const Vec3 way(0.02, 0.02, 0.04);
  const RequestId id =
      bench.post(SetPoses{{track("LArm", Space::Torso, kMaskPosition, way, 1)}, 0.1, true});
  const JointArray<double> before = bench.engine.state().command.angle;
  bench.cycle();
  ASSERT_NE(bench.findOutcome(id), nullptr);
  EXPECT_TRUE(bench.engine.state().tasks.empty());
  const JointArray<double> after = bench.engine.state().command.angle;
  for (std::size_t i = 0; i < after.size(); ++i) {
    EXPECT_LE(std::abs(after[i] - before[i]),
              0.1 * bench.model->actuators[i].max_velocity * 0.01 + 1e-12);
  }
  bench.run(3);
  EXPECT_NEAR((placeOf("LArm", Space::Torso).translation() - start - way).norm(), 0, kReach);
}

TEST_F(CartesianTest, WhatIsCopiedOnTheWayGoesOnAlike) {
  bench.post(
      InterpolatePoses{{track("Torso", Space::Robot, kMaskAll, Vec3(0, 0.02, -0.02), 1.0)}, true});
  bench.run(0.4);
  MotionEngine copy = bench.engine;
  SensorFrame frame = bench.frame;
  for (int i = 0; i < 80; ++i) {
    const JointArray<double> one = bench.cycle().angle;
    const JointArray<double> other = copy.update(frame).angle;
    frame = bench.frame;
    for (std::size_t k = 0; k < one.size(); ++k) ASSERT_EQ(one[k], other[k]);
  }
}

}  // namespace
}  // namespace nao::motion
