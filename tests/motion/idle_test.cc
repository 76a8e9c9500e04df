#include "motion/idle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/motion/test_robot.h"

namespace nao::motion {
namespace {

using Mode = SetIdle::Mode;
constexpr double kDegree = M_PI / 180;
constexpr double kExact = 1e-9;

std::vector<Joint> allOf(const RobotModel& model) {
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < model.jointCount(); ++i) joints.push_back(toJoint(i));
  return joints;
}

// Awake in StandInit.
struct Idling : EngineBench {
  Idling() {
    post(WakeUp{});
    run(6);
    EXPECT_TRUE(engine.state().awake);
  }
  void idle(Mode mode) { post(SetIdle{allOf(*makeTestRobot()), mode}); }

  // Largest and smallest command of a joint over some time, soles' slope included.
  struct Range {
    double low = 1e9, high = -1e9, sole = 0;
    int beats = 0;
  };
  Range watch(const char* name, double seconds) {
    Range range;
    const double start_slope =
        command("LHipPitch") + command("LKneePitch") + command("LAnklePitch");
    double before = command(name);
    bool rising = false;
    for (double t = 0; t < seconds; t += 0.01) {
      cycle();
      const double now = command(name);
      range.low = std::min(range.low, now);
      range.high = std::max(range.high, now);
      range.sole = std::max(range.sole, std::abs(command("LHipPitch") + command("LKneePitch") +
                                                 command("LAnklePitch") - start_slope));
      if (now > before + kExact && !rising) ++range.beats;
      if (std::abs(now - before) > kExact) rising = now > before;
      before = now;
    }
    return range;
  }
};

TEST(Idle, NobodyBreathesUntilTold) {
  Idling bench;
  const double knee = bench.command("LKneePitch");
  const auto range = bench.watch("LKneePitch", 5);
  EXPECT_EQ(range.low, knee);
  EXPECT_EQ(range.high, knee);
}

TEST(Idle, BreathingMovesAtMostFiveDegreesTwelveTimesAMinuteWithFlatSoles) {
  Idling bench;
  bench.post(SetBreath{12, 0});
  bench.idle(Mode::Breath);
  const auto range = bench.watch("LKneePitch", 30);
  EXPECT_GT(range.high - range.low, 1 * kDegree);
  EXPECT_LE(range.high - range.low, 5 * kDegree);
  EXPECT_NEAR(range.sole, 0, kExact);
  EXPECT_EQ(range.beats, 6);
}

TEST(Idle, HighAmplitudeIsOnlyForSlowBreath) {
  const auto rangeOf = [](SetBreath config) {
    Idling bench;
    bench.post(config);
    bench.idle(Mode::Breath);
    const auto range = bench.watch("RElbowRoll", 30);
    return range.high - range.low;
  };
  const double least = rangeOf({12, 0});
  EXPECT_NEAR(rangeOf({5, 1}), 2 * least, 0.02 * least);
  EXPECT_NEAR(rangeOf({30, 1}), least, 0.02 * least);
  EXPECT_NEAR(rangeOf({12, 1}), (1 + 18.0 / 25) * least, 0.02 * least);
}

TEST(Idle, ACommandOverridesAndBreathGoesOnAfterIt) {
  Idling bench;
  bench.idle(Mode::Breath);
  bench.run(4);
  bench.post(SetAngles{{bench.joint("LShoulderPitch")}, {0.5}, {1}});
  bench.run(0.5);
  EXPECT_NEAR(bench.command("LShoulderPitch"), 0.5, 3 * kDegree);
  const auto range = bench.watch("LShoulderPitch", 60);
  EXPECT_GE(range.low, 0.5 - kExact);  // no drift
  EXPECT_GT(range.high, 0.5 + 1 * kDegree);
}

TEST(Idle, OffGivesBackThePoseSmoothly) {
  Idling bench;
  const double elbow = bench.command("RElbowRoll");
  bench.idle(Mode::Breath);
  bench.run(7.3);
  bench.idle(Mode::Nothing);
  double before = bench.command("RElbowRoll");
  EXPECT_NE(before, elbow);
  for (int i = 0; i < 200; ++i) {
    bench.cycle();
    EXPECT_LT(std::abs(bench.command("RElbowRoll") - before), 0.2 * kDegree);
    before = bench.command("RElbowRoll");
  }
  EXPECT_NEAR(bench.command("RElbowRoll"), elbow, kExact);
}

TEST(Idle, PostureModeReturnsToWhereItWasSwitchedOn) {
  Idling bench;
  const double start = bench.command("RShoulderPitch");
  bench.idle(Mode::Posture);
  bench.post(SetAngles{{bench.joint("RShoulderPitch")}, {start - 0.4}, {1}});
  bench.run(0.2);
  EXPECT_LT(bench.command("RShoulderPitch"), start - 0.2);
  bench.run(3);
  EXPECT_NEAR(bench.command("RShoulderPitch"), start, kExact);
}

TEST(Idle, ACopyBreathesOnAsTheOriginal) {
  Idling bench;
  bench.idle(Mode::Breath);
  bench.run(3.3);
  MotionEngine copy = bench.engine;
  for (int i = 0; i < 300; ++i) {
    bench.frame.time += std::chrono::milliseconds(10);
    const JointCommand a = bench.engine.update(bench.frame);
    const JointCommand b = copy.update(bench.frame);
    ASSERT_EQ(a.angle[bench.joint("LKneePitch")], b.angle[bench.joint("LKneePitch")]);
  }
}

}  // namespace
}  // namespace nao::motion
