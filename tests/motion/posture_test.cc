#include "motion/postures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

using Kind = MotionOutcome::Kind;

TEST(WakeUp, StiffensWithinASecondAndStandsUpFromCrouch) {
  EngineBench bench;
  const RequestId id = bench.post(WakeUp{});
  bench.run(0.3);
  const double half_way = bench.engine.state().command.stiffness[0];
  EXPECT_GT(half_way, 0.2);
  EXPECT_LT(half_way, 0.8);
  EXPECT_DOUBLE_EQ(bench.command("LKneePitch"), 2.11);  // no jump while it stiffens
  bench.run(0.5);
  EXPECT_DOUBLE_EQ(bench.engine.state().command.stiffness[0], 1);
  EXPECT_TRUE(bench.engine.state().awake);
  EXPECT_GT(bench.cyclesUntilEnd(id), 0);
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Done);
  EXPECT_NEAR(bench.command("LKneePitch"), 0.7, 1e-9);
}

TEST(WakeUp, KeepsThePoseOfARobotThatStands) {
  EngineBench bench;
  bench.frame.angle = bench.model->findPosture("Stand")->angle;
  const RequestId id = bench.post(WakeUp{});
  EXPECT_LE(bench.cyclesUntilEnd(id), 100);
  EXPECT_NEAR(bench.command("LKneePitch"), bench.model->actuators[9].lower, 1e-3);
}

TEST(WakeUp, KeepsThePoseOfARobotThatLies) {
  EngineBench bench;
  bench.frame.angle_y = 1.5;
  bench.post(WakeUp{});
  bench.run(4);
  EXPECT_DOUBLE_EQ(bench.command("LKneePitch"), 2.11);
}

TEST(Rest, CrouchesBeforeItGoesLimp) {
  EngineBench bench;
  bench.pose("Stand");
  bench.post(Rest{});
  double knee_when_soft = -1;
  for (int i = 0; i < 600; ++i) {
    bench.cycle();
    const bool soft = bench.engine.state().command.stiffness[0] < 1;
    if (soft && knee_when_soft < 0) knee_when_soft = bench.command("LKneePitch");
  }
  EXPECT_NEAR(knee_when_soft, 2.11, 1e-6);
  EXPECT_DOUBLE_EQ(bench.engine.state().command.stiffness[0], 0);
  EXPECT_FALSE(bench.engine.state().awake);
}

TEST(Rest, OfALimpRobotOnlyStaysLimp) {
  EngineBench bench;
  const RequestId id = bench.post(Rest{});
  EXPECT_LE(bench.cyclesUntilEnd(id), 2);
}

TEST(GoToPosture, ArrivesAndSaysSo) {
  EngineBench bench;
  bench.pose("StandInit");
  const RequestId id = bench.post(GoToPosture{"Stand", 0.5});
  EXPECT_GT(bench.cyclesUntilEnd(id), 0);
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Done);
  EXPECT_NEAR(bench.command("LShoulderPitch"), 1.4717, 1e-9);
}

TEST(GoToPosture, KeepsASpeedAtWhichARobotStands) {
  EngineBench bench;
  bench.pose("Crouch");
  bench.post(GoToPosture{"Stand", 1.0});
  double fastest = 0;
  double before = bench.command("LKneePitch");
  for (int i = 0; i < 400; ++i) {
    bench.cycle();
    fastest = std::max(fastest, std::abs(bench.command("LKneePitch") - before) / 0.01);
    before = bench.command("LKneePitch");
  }
  EXPECT_LT(fastest, 2.0);  // [rad/s] of 6.4
}

TEST(GoToPosture, FailsWhenTheRobotDoesNotGetThere) {
  EngineBench bench;
  bench.pose("Crouch");
  const RequestId id = bench.post(GoToPosture{"StandInit", 0.5});
  for (int i = 0; i < 600 && bench.findOutcome(id) == nullptr; ++i) {
    bench.frame.angle[bench.joint("LKneePitch")] = 2.11;  // somebody holds it
    bench.engine.update(bench.frame);
    for (const MotionOutcome& outcome : bench.engine.takeOutcomes()) {
      bench.outcomes.push_back(outcome);
    }
  }
  ASSERT_NE(bench.findOutcome(id), nullptr);
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Failed);
  EXPECT_EQ(bench.findOutcome(id)->reason, "the robot did not arrive in the posture StandInit");
}

TEST(GoToPosture, RefusesAnUnknownName) {
  EngineBench bench;
  const RequestId id = bench.post(GoToPosture{"Handstand", 0.5});
  bench.cycle();
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Failed);
}

TEST(Postures, AreToldApartBySensors) {
  const auto model = makeTestRobot();
  SensorFrame frame;
  frame.angle = model->findPosture("Stand")->angle;
  ASSERT_NE(findCurrentPosture(*model, frame), nullptr);
  EXPECT_EQ(findCurrentPosture(*model, frame)->name, "Stand");
  EXPECT_EQ(currentFamily(*model, frame), "Standing");
  frame.angle_y = -1.5;
  EXPECT_EQ(findCurrentPosture(*model, frame), nullptr);
  EXPECT_EQ(currentFamily(*model, frame), "LyingBack");
  frame.angle_y = 0;
  frame.angle[*model->findJoint("LKneePitch")] = 1.0;
  EXPECT_EQ(findCurrentPosture(*model, frame), nullptr);
  EXPECT_EQ(currentFamily(*model, frame), "Unknown");
}

}  // namespace
}  // namespace nao::motion
