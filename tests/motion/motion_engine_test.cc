#include "motion/motion_engine.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

using Kind = MotionOutcome::Kind;
constexpr double kExact = 1e-9;

Interpolate interpolateTo(Joint joint, double angle, double time) {
  Key key;
  key.time = time;
  key.angle = angle;
  Interpolate request;
  request.curves.push_back({joint, {key}});
  return request;
}

TEST(MotionEngine, StartsLimpInTheStartPosture) {
  EngineBench bench;
  const MotionState state = bench.engine.state();
  EXPECT_DOUBLE_EQ(bench.command("LKneePitch"), 2.11);
  EXPECT_DOUBLE_EQ(state.command.stiffness[bench.joint("LKneePitch")], 0);
  EXPECT_FALSE(state.awake);
  EXPECT_EQ(state.last_accepted, 0u);
}

TEST(MotionEngine, LimpJointsCommandWhatTheySense) {
  EngineBench bench;
  bench.frame.angle[bench.joint("HeadYaw")] = 0.7;
  bench.cycle();
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), 0.7);
  bench.stiffen();
  bench.frame.angle[bench.joint("HeadYaw")] = 0.2;  // pushed, now stiff
  bench.cycle();
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), 0.7);
}

TEST(MotionEngine, SetAnglesMovesAtTheFractionOfTopSpeed) {
  EngineBench bench;
  bench.stiffen();
  const Joint yaw = bench.joint("HeadYaw");
  bench.post(SetAngles{{yaw}, {1.0}, {0.1}});
  bench.run(0.5);
  EXPECT_NEAR(bench.command("HeadYaw"), 0.5 * 0.1 * 8.268, kExact);
  bench.run(1.0);
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), 1.0);
}

TEST(MotionEngine, SetAnglesEndsAtOnceAndBooksNothing) {
  EngineBench bench;
  bench.stiffen();
  const RequestId id = bench.post(SetAngles{{bench.joint("HeadYaw")}, {1.0}, {0.1}});
  bench.cycle();
  ASSERT_NE(bench.findOutcome(id), nullptr);
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Done);
  EXPECT_TRUE(bench.engine.state().tasks.empty());
}

TEST(MotionEngine, ChangeAnglesAddsToTheCommand) {
  EngineBench bench;
  bench.stiffen();
  bench.post(SetAngles{{bench.joint("LShoulderPitch")}, {-0.6}, {1}, true});
  bench.run(1);
  EXPECT_NEAR(bench.command("LShoulderPitch"), 1.0, kExact);
}

TEST(MotionEngine, SetAnglesOnALimpJointIsForgotten) {
  EngineBench bench;
  bench.post(SetAngles{{bench.joint("HeadYaw")}, {1.0}, {1}});
  bench.run(0.1);
  bench.stiffen();
  bench.run(0.5);
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), 0);
}

TEST(MotionEngine, InterpolationReachesItsKeyWhenItSaid) {
  EngineBench bench;
  bench.stiffen();
  const RequestId id = bench.post(interpolateTo(bench.joint("HeadYaw"), 1, 1.0));
  bench.run(0.5);
  EXPECT_NEAR(bench.command("HeadYaw"), 0.5, 1e-6);
  EXPECT_EQ(bench.findOutcome(id), nullptr);
  EXPECT_EQ(bench.cyclesUntilEnd(id), 50);
  EXPECT_EQ(bench.findOutcome(id)->kind, Kind::Done);
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), 1);
}

TEST(MotionEngine, RelativeInterpolationAddsToTheStart) {
  EngineBench bench;
  bench.pose("StandInit");
  Interpolate request = interpolateTo(bench.joint("LShoulderPitch"), -0.5, 0.5);
  request.relative = true;
  bench.post(request);
  bench.run(0.6);
  EXPECT_NEAR(bench.command("LShoulderPitch"), 0.9, kExact);
}

TEST(MotionEngine, ASecondInterpolationOfAJointWaits) {
  EngineBench bench;
  bench.stiffen();
  const RequestId first = bench.post(interpolateTo(bench.joint("HeadYaw"), 1, 0.5));
  const RequestId second = bench.post(interpolateTo(bench.joint("HeadYaw"), 0, 0.5));
  const RequestId other = bench.post(interpolateTo(bench.joint("HeadPitch"), 0.2, 0.5));
  EXPECT_EQ(bench.cyclesUntilEnd(first), 50);
  EXPECT_NE(bench.findOutcome(other), nullptr);  // other joints do not wait
  EXPECT_EQ(bench.findOutcome(second), nullptr);
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), 1);
  EXPECT_EQ(bench.cyclesUntilEnd(second), 50);
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), 0);
}

TEST(MotionEngine, NobodyIsOvertakenForEver) {
  EngineBench bench;
  bench.stiffen();
  bench.post(interpolateTo(bench.joint("HeadYaw"), 1, 0.5));
  Interpolate both = interpolateTo(bench.joint("HeadYaw"), 0, 0.5);
  both.curves.push_back(interpolateTo(bench.joint("HeadPitch"), 0.1, 0.5).curves[0]);
  const RequestId second = bench.post(both);
  const RequestId third = bench.post(interpolateTo(bench.joint("HeadPitch"), 0.3, 0.5));
  EXPECT_EQ(bench.cyclesUntilEnd(second), 100);
  EXPECT_EQ(bench.findOutcome(third), nullptr);
}

TEST(MotionEngine, SetAnglesTakesAJointOverFromAnInterpolation) {
  EngineBench bench;
  bench.stiffen();
  Interpolate both = interpolateTo(bench.joint("HeadYaw"), 1, 1);
  both.curves.push_back(interpolateTo(bench.joint("HeadPitch"), 0.1, 1).curves[0]);
  const RequestId id = bench.post(both);
  bench.run(0.2);
  bench.post(SetAngles{{bench.joint("HeadYaw")}, {-0.5}, {1}});
  EXPECT_EQ(bench.cyclesUntilEnd(id), 80);
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), -0.5);
  EXPECT_NEAR(bench.command("HeadPitch"), 0.1, kExact);
}

TEST(MotionEngine, SpeedInterpolationStaysBelowItsFractionAndIsPrompt) {
  EngineBench bench;
  bench.pose("StandInit");
  const Joint yaw = bench.joint("HeadYaw");
  const Joint pitch = bench.joint("HeadPitch");
  const RequestId id = bench.post(InterpolateWithSpeed{{yaw, pitch}, {1.5, 0.1}, 0.2});
  double fastest = 0;
  double before = 0;
  int cycles = 0;
  while (bench.findOutcome(id) == nullptr && cycles < 1000) {
    bench.cycle();
    fastest = std::max(fastest, std::abs(bench.command("HeadYaw") - before) / 0.01);
    before = bench.command("HeadYaw");
    ++cycles;
  }
  EXPECT_LE(fastest, 0.2 * 8.268 * (1 + 1e-9));
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), 1.5);
  EXPECT_LT(cycles * 0.01, 1.5 / (0.2 * 8.268) + 0.25);  // the way at top speed and one ramp
}

TEST(MotionEngine, BothJointsOfASpeedInterpolationArriveTogether) {
  EngineBench bench;
  bench.pose("StandInit");
  bench.post(InterpolateWithSpeed{{bench.joint("HeadYaw"), bench.joint("HeadPitch")}, {1, 0.1}, 1});
  for (int i = 0; i < 20; ++i) {
    bench.cycle();
    EXPECT_NEAR(bench.command("HeadPitch"), 0.1 * bench.command("HeadYaw"), kExact);
  }
}

TEST(MotionEngine, KillEndsARunningAndAWaitingMotion) {
  EngineBench bench;
  bench.stiffen();
  const RequestId first = bench.post(interpolateTo(bench.joint("HeadYaw"), 1, 1));
  const RequestId second = bench.post(interpolateTo(bench.joint("HeadYaw"), 0, 1));
  bench.run(0.5);
  const double held = bench.command("HeadYaw");
  bench.post(Kill{second});
  bench.post(Kill{first});
  bench.run(0.5);
  EXPECT_EQ(bench.findOutcome(first)->kind, Kind::Killed);
  EXPECT_EQ(bench.findOutcome(second)->kind, Kind::Killed);
  EXPECT_DOUBLE_EQ(bench.command("HeadYaw"), held);
}

TEST(MotionEngine, EveryRequestGetsExactlyOneOutcome) {
  EngineBench bench;
  bench.pose("StandInit");
  bench.post(interpolateTo(bench.joint("HeadYaw"), 1, 0.3));
  bench.post(SetAngles{{bench.joint("HeadYaw")}, {0.1}, {1}});
  bench.post(GoToPosture{"Stand", 0.8});
  bench.post(GoToPosture{"Nowhere", 0.8});
  bench.post(MoveInit{});
  bench.post(Move{{0.1, 0, 0}, {}});
  bench.post(MoveTo{{0.1, 0, 0}, {}, {}});
  bench.post(MoveTo{{0.2, 0, 0}, {}, {}});
  bench.post(StopMove{});
  bench.post(Kill{4711});
  bench.post(InterpolateStiffness{{{bench.joint("HeadYaw"), {0.5}, {0.2}}}});
  bench.post(Rest{});
  bench.run(3);
  bench.post(KillAll{});
  bench.post(WakeUp{});
  bench.post(SetMoveArms{false, true});
  bench.post(KillMove{});
  bench.run(10);
  std::vector<RequestId> ids;
  for (const MotionOutcome& outcome : bench.outcomes) ids.push_back(outcome.id);
  std::sort(ids.begin(), ids.end());
  ASSERT_EQ(ids.size(), bench.last_id);
  for (std::size_t i = 0; i < ids.size(); ++i) EXPECT_EQ(ids[i], i + 1);
}

TEST(MotionEngine, AThousandMotionsMayWaitAndNoMore) {
  EngineBench bench;
  bench.stiffen();
  bench.post(interpolateTo(bench.joint("HeadYaw"), 1, 100));
  bench.cycle();
  for (int i = 0; i < 1000; ++i) bench.post(interpolateTo(bench.joint("HeadYaw"), 0, 1));
  const RequestId one_too_many = bench.post(interpolateTo(bench.joint("HeadYaw"), 0, 1));
  bench.cycle();
  EXPECT_EQ(bench.outcomes.back().id, one_too_many);
  EXPECT_EQ(bench.outcomes.back().kind, Kind::Failed);
}

TEST(MotionEngine, CommandsStayWithinTheJointsRange) {
  EngineBench bench;
  bench.stiffen();
  bench.post(interpolateTo(bench.joint("LElbowRoll"), 3, 0.2));
  bench.run(0.3);
  EXPECT_DOUBLE_EQ(bench.command("LElbowRoll"), -0.0349);
}

TEST(MotionEngine, TurningTheHeadLimitsItsNod) {
  EngineBench bench;
  bench.pose("StandInit");
  bench.post(SetAngles{{bench.joint("HeadPitch")}, {0.515}, {1}});
  bench.run(0.5);
  EXPECT_NEAR(bench.command("HeadPitch"), 0.5149, kExact);
  bench.post(SetAngles{{bench.joint("HeadYaw")}, {1.53}, {1}});
  bench.run(0.5);
  EXPECT_NEAR(bench.command("HeadPitch"), 0.2, kExact);
}

TEST(MotionEngine, ListsWhatRuns) {
  EngineBench bench;
  bench.stiffen();
  const RequestId id = bench.post(interpolateTo(bench.joint("HeadYaw"), 1, 1));
  bench.cycle();
  const auto tasks = bench.engine.state().tasks;
  ASSERT_EQ(tasks.size(), 1u);
  EXPECT_EQ(tasks[0].id, id);
  EXPECT_EQ(tasks[0].name, "angleInterpolation");
  EXPECT_EQ(tasks[0].joints, std::vector<Joint>{bench.joint("HeadYaw")});
}

TEST(MotionEngine, TellsWhichRequestsItHasTaken) {
  EngineBench bench;
  bench.post(StopMove{});
  bench.post(StopMove{});
  EXPECT_EQ(bench.engine.state().last_accepted, 2u);
}

TEST(MotionEngine, StiffnessFollowsStraightLines) {
  EngineBench bench;
  const Joint yaw = bench.joint("HeadYaw");
  const RequestId id = bench.post(InterpolateStiffness{{{yaw, {1, 0.5}, {1, 2}}}});
  bench.run(0.5);
  EXPECT_NEAR(bench.engine.state().command.stiffness[yaw], 0.5, kExact);
  EXPECT_EQ(bench.cyclesUntilEnd(id), 150);
  EXPECT_DOUBLE_EQ(bench.engine.state().command.stiffness[yaw], 0.5);
}

TEST(MotionEngine, SameRequestsSameCommands) {
  EngineBench a;
  EngineBench b;
  for (EngineBench* bench : {&a, &b}) {
    bench->post(WakeUp{});
    bench->post(GoToPosture{"Stand", 0.5});
    bench->post(interpolateTo(bench->joint("HeadYaw"), 1, 0.7));
    bench->post(MoveTo{{0.2, 0, 0}, {}, {}});
  }
  for (int i = 0; i < 800; ++i) {
    const JointCommand left = a.cycle();
    const JointCommand right = b.cycle();
    ASSERT_TRUE(std::equal(left.angle.begin(), left.angle.end(), right.angle.begin()));
  }
}

}  // namespace
}  // namespace nao::motion
