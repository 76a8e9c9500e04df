#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

constexpr double kStep = 0.002;

// What the servo is told, step by step, when `wanted(t)` is sent.
template <class Wanted>
std::vector<double> followed(const std::vector<EffectSetting>& effects, int steps, Wanted wanted) {
  EffectChain chain = chainOf(*nao::test::pendulum(1, 1), effects);
  std::vector<double> angles;
  for (int i = 0; i < steps; ++i) {
    JointCommand command{JointArray<double>(1, wanted(i * kStep)), JointArray<double>(1, 1.0)};
    chain.alterCommand(command, SimTime() + fromSeconds(i * kStep), kStep);
    angles.push_back(command.angle[0]);
  }
  return angles;
}

double sine(double t) { return 0.3 * std::sin(2 * M_PI * t); }
double step(double t) { return t < 0.01 - 1e-9 ? 0 : 1; }
double ramp(double t) { return 0.7 * t; }

// The rod's way after a swinging command that begins at `begin`.
std::vector<double> way(const std::vector<EffectSetting>& effects, double begin) {
  Rig rig(nao::test::pendulum(0.5, 0.2), effects, 0, kStep);
  std::vector<double> angles;
  for (int i = 0; i < 500; ++i) {
    const double t = i * kStep - begin;
    rig.command.angle[0] = t > 0 ? sine(t) : 0;
    rig.step();
    angles.push_back(rig.angle());
  }
  return angles;
}

TEST(CommandLatency, ShiftsTheJointsWholeWay) {
  const std::vector<double> late = way({effect("command_latency", {{"delay", 0.03}})}, 0);
  const std::vector<double> prompt = way({}, 0);
  for (std::size_t i = 15; i < late.size(); ++i) ASSERT_DOUBLE_EQ(late[i], prompt[i - 15]) << i;
  EXPECT_EQ(late[14], 0);
}

TEST(CommandLatency, OfAPartOfAStepIsTheMeanOverTheStep) {
  const auto late = followed({effect("command_latency", {{"delay", 0.0055}})}, 100, ramp);
  for (std::size_t i = 10; i < late.size(); ++i) {
    ASSERT_NEAR(late[i], ramp(static_cast<double>(i) * kStep - 0.0055), 1e-12);
  }
}

TEST(CommandLatency, DelaysStiffnessToo) {
  EffectChain chain =
      chainOf(*nao::test::pendulum(1, 1), {effect("command_latency", {{"delay", 0.006}})});
  std::vector<double> stiffness;
  for (int i = 0; i < 6; ++i) {
    JointCommand command{JointArray<double>(1), JointArray<double>(1, i < 1 ? 0.0 : 1.0)};
    chain.alterCommand(command, {}, kStep);
    stiffness.push_back(command.stiffness[0]);
  }
  EXPECT_EQ(stiffness, (std::vector<double>{0, 0, 0, 0, 1, 1}));
}

TEST(CommandHold, MakesAStaircaseOfItsInterval) {
  const auto held = followed({effect("command_hold", {{"interval", 0.02}})}, 100, ramp);
  for (std::size_t i = 0; i < held.size(); ++i) {
    ASSERT_DOUBLE_EQ(held[i], ramp(static_cast<double>(i / 10 * 10) * kStep)) << i;
  }
}

TEST(CommandHold, KeepsItsRhythmWhereTheIntervalIsNoWholeNumberOfSteps) {
  const auto held = followed({effect("command_hold", {{"interval", 0.025}})}, 1001, ramp);
  int taken = 0;
  for (std::size_t i = 1; i < held.size(); ++i) taken += held[i] != held[i - 1];
  EXPECT_EQ(taken, 80);  // 2 s / 25 ms
}

TEST(CommandHold, TicksFirstWhenItsPhaseHasPassed) {
  const auto held =
      followed({effect("command_hold", {{"interval", 0.02}, {"phase", 0.006}})}, 50, ramp);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const std::size_t taken = i < 3 ? 0 : (i - 3) / 10 * 10 + 3;
    ASSERT_DOUBLE_EQ(held[i], ramp(static_cast<double>(taken) * kStep)) << i;
  }
}

TEST(RateLimit, TurnsAStepIntoARamp) {
  const auto limited = followed({effect("rate_limit", {{"rate", 5}})}, 200, step);
  for (std::size_t i = 5; i < limited.size(); ++i) {
    const double t = static_cast<double>(i - 4) * kStep;  // the step comes at i = 5
    ASSERT_NEAR(limited[i], std::min(1.0, 5 * t), 1e-12);
  }
}

// From where less is left than the ramp goes in the time of its ease, it goes on as an exponential.
TEST(RateLimit, MayArriveGently) {
  constexpr double kRate = 5, kEase = 0.002;
  const auto limited =
      followed({effect("rate_limit", {{"rate", kRate}, {"ease", kEase}})}, 250, step);
  const double part = 1 - std::exp(-kStep / kEase);  // of what is left, in a step
  for (std::size_t i = 5; i < limited.size(); ++i) {
    const double left = 1 - (i > 5 ? limited[i - 1] : 0);
    ASSERT_NEAR(limited[i], 1 - left + std::min(kRate * kStep, part * left), 1e-12);
  }
}

TEST(CommandFilter, AnswersAStepWithAnExponential) {
  constexpr double kTime = 0.03;
  const auto smooth = followed({effect("command_filter", {{"time", kTime}})}, 200, step);
  for (std::size_t i = 5; i < smooth.size(); ++i) {
    const double t = static_cast<double>(i - 4) * kStep;
    ASSERT_NEAR(smooth[i], 1 - std::exp(-t / kTime), 1e-12);
  }
}

TEST(CommandEffects, ActInTheOrderOfTheFile) {
  const EffectSetting late = effect("command_latency", {{"delay", 0.004}});
  const EffectSetting held = effect("command_hold", {{"interval", 0.02}});
  const auto late_first = followed({late, held}, 30, ramp);
  const auto held_first = followed({held, late}, 30, ramp);
  EXPECT_DOUBLE_EQ(late_first[10], ramp(0.016));
  EXPECT_DOUBLE_EQ(held_first[10], ramp(0));
}

TEST(CommandEffects, LeaveOtherJointsAlone) {
  const auto nao = nao::test::robot("nao_h21_v33_ideal");
  const std::size_t knee = index(*nao->findJoint("LKneePitch"));
  EffectChain chain = chainOf(*nao, {effectOn(knee, "command_filter", {{"time", 1}})});
  JointCommand command{JointArray<double>(nao->jointCount(), 0.0),
                       JointArray<double>(nao->jointCount(), 1.0)};
  chain.alterCommand(command, {}, kStep);
  command.angle = JointArray<double>(nao->jointCount(), 1.0);
  chain.alterCommand(command, {}, kStep);
  for (std::size_t j = 0; j < nao->jointCount(); ++j) {
    if (j == knee) {
      EXPECT_LT(command.angle[j], 0.01);
    } else {
      EXPECT_EQ(command.angle[j], 1) << j;
    }
  }
}

}  // namespace
}  // namespace nao::sim::test
