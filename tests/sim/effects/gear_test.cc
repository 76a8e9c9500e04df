#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

constexpr double kKp = 150;  // [N m/rad] of tests/support's pendulum

std::shared_ptr<RobotModel> geared() {
  auto model = nao::test::pendulum(0.5, 0.2);
  model->actuators[0].rotor_inertia = 0.005;
  return model;
}

// Where rod and encoder rest under `pull`.
std::pair<double, double> restUnder(Rig& rig, double pull) {
  rig.pull = pull;
  rig.run(2);
  return {rig.angle(), rig.encoder()};
}

TEST(Backlash, LosesItsWidthWhenTheLoadTurnsRoundAndTheEncoderDoesNotSeeIt) {
  constexpr double kWidth = 0.024;
  constexpr double kPull = 1;  // [N m]
  Rig rig(geared(), {effect("backlash", {{"width", kWidth}})});
  const auto [rod_up, encoder_up] = restUnder(rig, kPull);
  const auto [rod_down, encoder_down] = restUnder(rig, -kPull);
  // The teeth of a gear with play alone give by pull / 2e4 N m/rad (sim/geared_motor.cc).
  EXPECT_NEAR(encoder_up - encoder_down, 2 * kPull / kKp, 1e-6);
  EXPECT_NEAR(rod_up - rod_down, 2 * kPull / kKp + kWidth + 2 * kPull / 2e4, 1e-6);
  EXPECT_NEAR(rod_up - encoder_up, rod_up - rod_down - (rod_up - encoder_down), 1e-3);
}

TEST(Backlash, OfSoftFlanksBendsBeyondItsWidth) {
  constexpr double kWidth = 0.024, kCompliance = 0.004, kPull = 1.5;
  Rig rig(geared(), {effect("backlash", {{"width", kWidth}, {"compliance", kCompliance}})});
  const auto [rod_up, encoder_up] = restUnder(rig, kPull);
  const auto [rod_down, encoder_down] = restUnder(rig, -kPull);
  const double lost = (rod_up - encoder_up) - (rod_down - encoder_down);
  EXPECT_NEAR(lost, kWidth + 2 * kPull * kCompliance, 1e-5);
}

TEST(Backlash, LetsTheRodSwingFreelyWithinIt) {
  Rig rig(geared(), {effect("backlash", {{"width", 0.2}})});
  rig.body().place({}, JointArray<double>(1, 0.0));
  rig.setSpeed(0, 0.5);
  rig.run(0.1);
  EXPECT_NEAR(rig.rate(), 0.5, 1e-9);
  EXPECT_NEAR(rig.angle(), 0.05, 1e-9);
  EXPECT_NEAR(rig.encoder(), 0, 1e-9);
}

TEST(GearCompliance, BendsInProportionToTheLoad) {
  constexpr double kCompliance = 0.01;  // [rad/(N m)]
  Rig rig(geared(), {effect("gear_compliance", {{"compliance", kCompliance}})});
  for (const double pull : {0.5, -1.5}) {
    const auto [rod, encoder] = restUnder(rig, pull);
    EXPECT_NEAR(rod - encoder, pull * kCompliance, 1e-6);
    EXPECT_NEAR(encoder, pull / kKp, 1e-6);
  }
}

TEST(GearCompliance, OfTwoEntriesIsTheirSum) {
  const EffectSetting one = effect("gear_compliance", {{"compliance", 0.004}});
  const EffectSetting other = effect("gear_compliance", {{"compliance", 0.006}});
  Rig rig(geared(), {one, other});
  const auto [rod, encoder] = restUnder(rig, 1);
  EXPECT_NEAR(rod - encoder, 0.01, 1e-6);
}

TEST(GearCompliance, LetsTheRodRingAgainstAStandingRotor) {
  constexpr double kCompliance = 0.02;
  auto model = geared();
  model->actuators[0].kp = 1e5;  // the rotor stands
  model->actuators[0].stall_torque = 1e5;
  Rig rig(model, {effect("gear_compliance", {{"compliance", kCompliance}, {"damping", 0}})}, 0,
          1e-4);
  rig.setSpeed(0, 0.1);
  int crossings = 0;
  double last = 0, before = 0;
  for (int i = 0; i < 10000; ++i) {
    rig.step();
    if (before < 0 && rig.angle() >= 0) {
      ++crossings;
      last = 1e-4 * (i + 1);
    }
    before = rig.angle();
  }
  const double period = 2 * M_PI * std::sqrt((0.5 * 0.04 + 1e-6) * kCompliance);
  // One part in 300: the servo's own softness is 1 / (1e5 * 0.02) of the gear's.
  EXPECT_NEAR(last / crossings, period, period / 300);
}

TEST(EncoderOffset, MovesTheJointAwayFromWhatItReports) {
  Rig rig(nao::test::pendulum(0.5, 0.2), {effect("encoder_offset", {{"angle", 0.03}})});
  rig.command.angle[0] = 0.2;
  rig.run(2);
  EXPECT_NEAR(rig.encoder(), 0.2, 1e-6);
  EXPECT_NEAR(rig.angle(), 0.17, 1e-6);
}

}  // namespace
}  // namespace nao::sim::test
