#include "motion/fall_manager.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

// A walking robot tips over forwards: at 0.9 rad for a fifth of a second, then it lies.
void fallForwards(EngineBench& bench) {
  bench.pose("StandInit");
  bench.post(MoveToward{1, 0, 0, {}});
  bench.run(0.5);
  ASSERT_TRUE(bench.engine.state().move_active);
  bench.frame.angle_y = 0.9;
  bench.run(0.2);
  bench.frame.angle_y = 1.5;
  bench.run(1.5);
}

double stiffest(const EngineBench& bench) {
  const JointArray<double> stiffness = bench.engine.state().command.stiffness;
  return *std::max_element(stiffness.begin(), stiffness.end());
}

TEST(FallManager, BendsThenLetsGoAndEndsTheWalk) {
  EngineBench bench;
  fallForwards(bench);
  const MotionState state = bench.engine.state();
  EXPECT_FALSE(state.move_active);
  EXPECT_TRUE(state.fallen);
  EXPECT_FALSE(state.falling);
  EXPECT_FALSE(state.awake);
  EXPECT_EQ(stiffest(bench), 0);
  EXPECT_NEAR(bench.command("LKneePitch"), 1.4, 1e-9);
  EXPECT_NEAR(bench.command("HeadPitch"), -0.3, 1e-9);
}

TEST(FallManager, SwitchedOffLeavesTheJointsStiff) {
  EngineBench bench;
  bench.post(SetFallManager{false});
  fallForwards(bench);
  EXPECT_FALSE(bench.engine.state().move_active);
  EXPECT_TRUE(bench.engine.state().fallen);
  EXPECT_EQ(stiffest(bench), 1);
}

TEST(FallManager, KillsWhatWasUnderWay) {
  EngineBench bench;
  bench.pose("StandInit");
  const RequestId head = bench.post(InterpolateWithSpeed{{bench.joint("HeadYaw")}, {2}, 0.01});
  bench.run(0.1);
  bench.frame.angle_x = 0.9;
  bench.cycle();
  ASSERT_NE(bench.findOutcome(head), nullptr);
  EXPECT_EQ(bench.findOutcome(head)->kind, MotionOutcome::Kind::Killed);
  ASSERT_EQ(bench.engine.state().tasks.size(), 1u);
  EXPECT_EQ(bench.engine.state().tasks[0].name, "fallManager");
}

TEST(WalkProtection, RefusesAndEndsAWalkWithoutGroundUnlessSwitchedOff) {
  for (const bool on : {true, false}) {
    EngineBench bench;
    bench.pose("StandInit");
    bench.post(SetWalkProtection{on, true});
    bench.post(MoveToward{1, 0, 0, {}});
    bench.run(0.5);
    for (FootForces& foot : bench.frame.feet) foot.total = 0;  // lifted
    bench.run(0.5);
    EXPECT_EQ(bench.engine.state().move_active, !on);
    bench.post(StopMove{});
    bench.run(0.5);
    bench.post(MoveToward{1, 0, 0, {}});
    bench.run(0.5);
    EXPECT_EQ(bench.engine.state().move_active, !on);
  }
}

TEST(WalkProtection, WalksOnSoftLegsOnlyWhenSwitchedOff) {
  for (const bool on : {true, false}) {
    EngineBench bench;
    bench.pose("StandInit");
    bench.post(SetWalkProtection{true, on});
    bench.post(SetStiffness{{bench.joint("LKneePitch")}, {0.5}});
    bench.post(MoveToward{1, 0, 0, {}});
    bench.run(0.5);
    EXPECT_EQ(bench.engine.state().move_active, !on);
  }
}

}  // namespace
}  // namespace nao::motion
