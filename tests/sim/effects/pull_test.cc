#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

std::shared_ptr<RobotModel> arm() { return nao::test::pendulum(0.5, 0.2); }
double kp() { return arm()->actuators[0].kp; }

// Where the arm comes to rest with this command, without gravity.
double restOf(const std::vector<EffectSetting>& effects, double command, double seconds = 2) {
  Rig rig(arm(), effects);
  rig.command.angle[0] = command;
  rig.run(seconds);
  return rig.angle();
}

TEST(TorqueBias, BendsTheServoByItsTorque) {
  EXPECT_NEAR(restOf({effect("torque_bias", {{"torque", 0.5}})}, 0), 0.5 / kp(), 1e-6);
}

TEST(CableSpring, SharesTheWayWithTheServo) {
  const double expected = kp() * 0.3 / (kp() + 2);
  EXPECT_NEAR(restOf({effect("cable_spring", {{"stiffness", 2}})}, 0.3), expected, 1e-6);
}

TEST(Cogging, PullsAsTheSineOfTheAngle) {
  const double angle =
      restOf({effect("cogging", {{"torque", 0.2}, {"per_turn", 5}, {"phase", 0.4}})}, 0.2);
  EXPECT_NEAR(kp() * (angle - 0.2), 0.2 * std::sin(5 * angle + 0.4), 1e-6);
}

TEST(EmpiricalTorque, AddsUpItsFeatures) {
  const double angle = restOf(
      {effect(
          "empirical_torque",
          {{"constant", 0.1}, {"q", -0.5}, {"cos_q", 0.2}, {"ripple", 5}, {"ripple_sin", 0.15}})},
      0.2);
  const double torque = 0.1 - 0.5 * angle + 0.2 * std::cos(angle) + 0.15 * std::sin(5 * angle);
  EXPECT_NEAR(kp() * (angle - 0.2), torque, 1e-6);
}

TEST(EmpiricalTorque, SticksWhereItResistsMotion) {
  const std::map<std::string, double> sign{{"constant", 0}, {"sign", -0.3}};
  EXPECT_NEAR(restOf({effect("empirical_torque", sign)}, 0.9 * 0.3 / kp()), 0, 1e-6);
}

TEST(JointStop, StopsTheJointWhereItIsMovedTo) {
  const auto model = arm();
  const double upper = model->coordinates[0].upper;
  const double free = restOf({}, upper - 0.1);
  EXPECT_NEAR(free, upper - 0.1, 1e-6);
  const double stopped =
      restOf({effect("joint_stop", {{"lower", 0}, {"upper", -0.3}})}, upper - 0.1);
  EXPECT_LT(stopped, upper - 0.25);
}

TEST(IntegralGain, TakesTheSagAway) {
  Rig rig(arm(), {effect("integral_gain", {{"gain", 100}})});
  rig.pull = 0.5;
  rig.run(10);
  EXPECT_NEAR(rig.angle(), 0, 1e-5);
}

}  // namespace
}  // namespace nao::sim::test
