#include "motion/walking.h"

#include <gtest/gtest.h>

#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

using Kind = MotionOutcome::Kind;
using Calls = std::vector<std::string>;

Interpolate interpolateTo(Joint joint, double angle, double time) {
  Key key;
  key.time = time;
  key.angle = angle;
  Interpolate request;
  request.curves.push_back({joint, {key}});
  return request;
}

class WalkingTest : public testing::Test {
 protected:
  WalkingTest() { bench.pose("StandInit"); }
  EngineBench bench;
};

TEST_F(WalkingTest, MoveToEndsWhenTheWalkDoes) {
  const RequestId id = bench.post(MoveTo{{0.3, 0.1, 0.5}, {}, {}});
  EXPECT_TRUE(bench.engine.state().move_active);
  bench.run(0.1);
  EXPECT_EQ(bench.gait->calls, Calls{"walkTo"});
  EXPECT_DOUBLE_EQ(bench.gait->target.y, 0.1);
  EXPECT_DOUBLE_EQ(bench.command("LKneePitch"), -0.092346);  // the fake's legs, in range
  EXPECT_EQ(bench.findOutcome(id), nullptr);
  bench.run(0.2);
  ASSERT_NE(bench.findOutcome(id), nullptr);
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Done);
  EXPECT_FALSE(bench.engine.state().move_active);
  EXPECT_TRUE(bench.engine.state().tasks.empty());
}

TEST_F(WalkingTest, MoveTowardEndsAtOnceAndWalksOn) {
  const RequestId id = bench.post(MoveToward{0.5, 0, 0.1, {}});
  bench.run(1);
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Done);
  EXPECT_TRUE(bench.engine.state().move_active);
  EXPECT_DOUBLE_EQ(bench.gait->velocity.x, 0.5);
}

TEST_F(WalkingTest, ANewVelocityReplacesTheOldWithoutAStop) {
  bench.post(MoveToward{0.5, 0, 0, {}});
  bench.run(0.5);
  bench.post(Move{{0.05, 0, 0}, {}});
  bench.run(0.5);
  EXPECT_EQ(bench.gait->calls, (Calls{"walkToward", "walkAt"}));
}

TEST_F(WalkingTest, ASecondMoveToTakesThePlaceOfTheFirst) {
  const RequestId first = bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.run(0.1);
  const RequestId second = bench.post(MoveTo{{0.1, 0, 0}, {}, {}});
  bench.cycle();
  EXPECT_EQ(bench.findOutcome(first)->kind, Kind::Killed);
  bench.run(0.3);
  EXPECT_EQ(bench.findOutcome(second)->kind, Kind::Done);
}

TEST_F(WalkingTest, ZeroVelocityStops) {
  bench.post(MoveToward{0.5, 0, 0, {}});
  bench.run(0.5);
  bench.post(MoveToward{0, 0, 0, {}});
  bench.run(0.1);
  EXPECT_EQ(bench.gait->calls, (Calls{"walkToward", "stop"}));
  EXPECT_FALSE(bench.engine.state().move_active);
}

TEST_F(WalkingTest, StopMoveEndsInDoubleSupport) {
  const RequestId walk = bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.run(0.05);
  const RequestId stop = bench.post(StopMove{});
  EXPECT_EQ(bench.cyclesUntilEnd(stop), 3);
  EXPECT_EQ(bench.findOutcome(stop)->kind, Kind::Done);
  EXPECT_EQ(bench.findOutcome(walk)->kind, Kind::Killed);
}

TEST_F(WalkingTest, StopMoveOfARobotThatStandsIsDoneAtOnce) {
  const RequestId stop = bench.post(StopMove{});
  EXPECT_EQ(bench.cyclesUntilEnd(stop), 1);
}

TEST_F(WalkingTest, KillMoveEndsAtOnce) {
  const RequestId walk = bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.run(0.05);
  bench.post(KillMove{});
  bench.cycle();
  EXPECT_EQ(bench.gait->calls.back(), "kill");
  EXPECT_EQ(bench.findOutcome(walk)->kind, Kind::Killed);
  EXPECT_FALSE(bench.engine.state().move_active);
}

TEST_F(WalkingTest, KillOfTheTaskStopsTheWalkGently) {
  const RequestId walk = bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.run(0.05);
  bench.post(Kill{walk});
  bench.cycle();
  EXPECT_EQ(bench.gait->calls.back(), "stop");
  EXPECT_EQ(bench.findOutcome(walk)->kind, Kind::Killed);
}

TEST_F(WalkingTest, SoftLegsDoNotWalk) {
  bench.post(SetStiffness{{bench.joint("LKneePitch")}, {0.5}});
  const RequestId id = bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.run(0.1);
  ASSERT_NE(bench.findOutcome(id), nullptr);
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Failed);
  EXPECT_TRUE(bench.gait->calls.empty());
}

TEST_F(WalkingTest, FromCrouchTheRobotStandsUpFirst) {
  bench.pose("Crouch");
  bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.run(0.5);
  EXPECT_TRUE(bench.gait->calls.empty());
  EXPECT_TRUE(bench.engine.state().move_active);
  bench.run(1.5);
  EXPECT_EQ(bench.gait->calls, Calls{"walkTo"});
}

TEST_F(WalkingTest, AStopBeforeTheFirstStepLeavesTheRobotStanding) {
  bench.pose("Crouch");
  const RequestId walk = bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.run(0.2);
  bench.post(StopMove{});
  bench.run(2);
  EXPECT_NEAR(bench.command("LKneePitch"), 0.7, 1e-9);  // not half way up
  EXPECT_EQ(bench.findOutcome(walk)->kind, Kind::Killed);
  EXPECT_TRUE(bench.gait->calls.empty());
}

TEST_F(WalkingTest, LegMotionsWaitForTheWalkAndTheWalkForThem) {
  bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.cycle();
  const RequestId kick = bench.post(interpolateTo(bench.joint("LHipPitch"), -0.8, 0.5));
  bench.run(0.1);
  EXPECT_DOUBLE_EQ(bench.command("LHipPitch"), bench.gait->legs);
  EXPECT_GT(bench.cyclesUntilEnd(kick), 40);
  bench.pose("StandInit");

  bench.gait->calls.clear();
  bench.post(interpolateTo(bench.joint("LHipPitch"), -0.5, 0.5));
  bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.run(0.3);
  EXPECT_TRUE(bench.gait->calls.empty());
  bench.run(0.3);
  EXPECT_EQ(bench.gait->calls, Calls{"walkTo"});
}

TEST_F(WalkingTest, SetAnglesCannotDisturbTheSteps) {
  bench.post(MoveToward{1, 0, 0, {}});
  bench.run(0.2);
  bench.post(SetAngles{{bench.joint("LHipPitch")}, {0.3}, {1}});
  bench.run(0.5);
  EXPECT_DOUBLE_EQ(bench.command("LHipPitch"), bench.gait->legs);
}

TEST_F(WalkingTest, ArmsSwingUnlessDisabledOrCommanded) {
  bench.post(SetMoveArms{true, false});
  bench.post(MoveToward{1, 0, 0, {}});
  bench.run(1);
  EXPECT_DOUBLE_EQ(bench.command("LShoulderPitch"), 1.2);
  EXPECT_DOUBLE_EQ(bench.command("RShoulderPitch"), 1.4);
  bench.post(SetAngles{{bench.joint("LShoulderPitch")}, {0.5}, {1}});
  bench.run(1);
  EXPECT_DOUBLE_EQ(bench.command("LShoulderPitch"), 0.5);
}

TEST_F(WalkingTest, ArmsJoinTheSwingWithoutAJump) {
  bench.post(SetAngles{{bench.joint("LShoulderPitch")}, {-1}, {1}});
  bench.run(1);
  bench.post(MoveToward{1, 0, 0, {}});
  bench.cycle();
  const double before = bench.command("LShoulderPitch");
  bench.cycle();
  EXPECT_NEAR(bench.command("LShoulderPitch") - before, 0.02, 1e-9);
}

TEST_F(WalkingTest, AFallEndsTheWalkWithAReason) {
  const RequestId walk = bench.post(MoveTo{{0.3, 0, 0}, {}, {}});
  bench.run(0.05);
  bench.frame.angle_x = 1.4;
  bench.cycle();
  EXPECT_TRUE(bench.engine.state().falling);
  EXPECT_EQ(bench.gait->calls.back(), "kill");
  EXPECT_EQ(bench.findOutcome(walk)->kind, Kind::Failed);
  EXPECT_EQ(bench.findOutcome(walk)->reason, "the robot fell");
  bench.run(0.5);
  EXPECT_TRUE(bench.engine.state().fallen);
  EXPECT_FALSE(bench.engine.state().falling);
}

TEST_F(WalkingTest, APostureStopsTheWalkFirst) {
  bench.post(MoveToward{1, 0, 0, {}});
  bench.run(0.2);
  const RequestId id = bench.post(GoToPosture{"StandInit", 0.8});
  bench.cycle();
  EXPECT_EQ(bench.gait->calls.back(), "stop");
  EXPECT_GT(bench.cyclesUntilEnd(id), 0);
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Done);
}

TEST_F(WalkingTest, TellsItsOdometryAndSteps) {
  bench.post(MoveToward{1, 0, 0, {}});
  bench.run(0.2);
  const MotionState state = bench.engine.state();
  EXPECT_GT(state.position.x, 0.01);
  EXPECT_NEAR(state.next_position.x - state.position.x, 0.04, 1e-9);
  EXPECT_EQ(state.footsteps.size(), 2u);
  ASSERT_EQ(state.tasks.size(), 1u);
  EXPECT_EQ(state.tasks[0].name, "move");
}

TEST(Walking, OfARobotWithoutLegsFails) {
  const auto model = makeTestRobot();
  MotionEngine engine(model, nullptr);
  SensorFrame frame;
  frame.angle = JointArray<double>(model->jointCount());
  engine.accept({1, MoveTo{{0.1, 0, 0}, {}, {}}});
  engine.update(frame);
  const auto outcomes = engine.takeOutcomes();
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_EQ(outcomes[0].kind, Kind::Failed);
  EXPECT_EQ(outcomes[0].reason, "this robot does not walk");
}

}  // namespace
}  // namespace nao::motion
