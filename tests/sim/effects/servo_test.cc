#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

constexpr double kMass = 0.5, kLength = 0.2, kGravity = 10;
constexpr double kWeight = kMass * kGravity * kLength;  // [N m] of the level rod

std::shared_ptr<RobotModel> arm() { return nao::test::pendulum(kMass, kLength); }
double kp() { return arm()->actuators[0].kp; }
double mostTorque() { return arm()->actuators[0].efficiency * arm()->actuators[0].stall_torque; }

// How far the rod rests below its command under `pull`.
double sag(const std::vector<EffectSetting>& effects, double pull) {
  Rig rig(arm(), effects);
  rig.pull = pull;
  rig.run(2);
  return rig.angle();
}

TEST(KpError, ChangesTheSagUnderALoadByItsInverse) {
  EXPECT_NEAR(sag({effect("kp_error", {{"part", 0.25}})}, 2), 2 / (1.25 * kp()), 1e-7);
  EXPECT_NEAR(sag({effect("kp_error", {{"part", -0.5}})}, 2), 2 / (0.5 * kp()), 1e-7);
}

TEST(KdError, ChangesTheLagBehindARampByItsShare) {
  constexpr double kRate = 0.5;  // [rad/s]
  for (const double part : {0.0, 0.4, -0.5}) {
    Rig rig(arm(), {effect("kd_error", {{"part", part}})});
    for (int i = 0; i < 1000; ++i) {
      rig.command.angle[0] = kRate * 0.001 * (i + 1);
      rig.step();
    }
    const double lag = rig.command.angle[0] - rig.angle();
    EXPECT_NEAR(lag, kRate * (1 + part) * arm()->actuators[0].kd / kp(), 1e-6) << part;
  }
}

TEST(ServoDeadband, AddsItsWidthToTheSagOnEitherSide) {
  const EffectSetting deadband = effect("servo_deadband", {{"width", 0.01}});
  EXPECT_NEAR(sag({deadband}, 2), 2 / kp() + 0.01, 1e-6);
  EXPECT_NEAR(sag({deadband}, -2), -2 / kp() - 0.01, 1e-6);
}

TEST(ServoDeadband, LeavesARodAloneThatIsNearEnough) {
  Rig rig(arm(), {effect("servo_deadband", {{"width", 0.01}})});
  rig.body().place({}, JointArray<double>(1, 0.009));
  rig.run(1);
  EXPECT_DOUBLE_EQ(rig.angle(), 0.009);
}

// A hyperbola: with g = T / kp + g(no torque), g (g - (|e| - width)) = (ease width / 2)^2.
TEST(ServoDeadband, MayEndWithoutAKink) {
  constexpr double kWidth = 0.01, kEase = 0.5;
  const EffectSetting eased = effect("servo_deadband", {{"width", kWidth}, {"ease", kEase}});
  const double bend = kEase * kWidth, at_rest = (std::hypot(kWidth, bend) - kWidth) / 2;
  for (const double pull : {0.01, 0.2, -0.2, 2.0}) {
    const double error = sag({eased}, pull);
    const double f = std::abs(pull) / kp() + at_rest, off = std::abs(error) - kWidth;
    EXPECT_NEAR(f * (f - off), bend * bend / 4, 1e-9) << pull;
    EXPECT_GT(error * pull, 0);
  }
  EXPECT_NEAR(sag({effect("servo_deadband", {{"width", kWidth}, {"ease", 1e-9}})}, 2),
              2 / kp() + kWidth, 1e-6);
}

// d = kp e / T_max of the servo holds (1 - part) d + part sqrt(d) = pull / T_max.
TEST(DutyRoot, HoldsALoadWithTheRootOfTheError) {
  for (const double pull : {0.2, -0.2, 2.0}) {
    const double error = sag({effect("duty_root", {{"part", 1}})}, pull);
    EXPECT_NEAR(error, std::copysign(pull * pull / mostTorque() / kp(), pull), 1e-7) << pull;
    const double half = sag({effect("duty_root", {{"part", 0.5}})}, pull);
    const double duty = kp() * std::abs(half) / mostTorque();
    EXPECT_NEAR(0.5 * duty + 0.5 * std::sqrt(duty), std::abs(pull) / mostTorque(), 1e-7) << pull;
  }
}

TEST(DutyRoot, ChangesNothingOfAMotorAtItsLimit) {
  for (const double part : {0.0, 1.0}) {
    Rig rig(arm(), {effect("duty_root", {{"part", part}})});
    rig.command.angle[0] = 3;
    rig.step();
    EXPECT_NEAR(rig.motorTorque(), mostTorque(), 1e-9) << part;
  }
}

TEST(TorqueLimit, ScalesTheMostTheMotorGives) {
  Rig rig(arm(), {effect("torque_limit", {{"part", 0.6}})});
  rig.command.angle[0] = 3;
  rig.step();
  EXPECT_NEAR(rig.motorTorque(), 0.6 * mostTorque(), 1e-9);
}

// The gear loses a part of what the motor gives, and of what turns the motor back.
TEST(TorqueLimit, ScalesTheLoadThatTheMotorHolds) {
  constexpr double kPart = 0.25;
  const Actuator motor = arm()->actuators[0];
  const double holds = kPart * motor.stall_torque / motor.efficiency;
  for (const double load : {0.95, 1.05}) {
    const double angle = sag({effect("torque_limit", {{"part", kPart}})}, load * holds);
    EXPECT_EQ(angle < 1, load < 1) << load;
  }
}

TEST(VoltageSag, TakesTorqueAtRestAndSpeedWithoutLoad) {
  Rig rig(arm(), {effect("voltage_sag", {{"drop", 0.25}})});
  rig.command.angle[0] = 9;
  rig.step();
  EXPECT_NEAR(rig.motorTorque(), 0.75 * mostTorque(), 1e-9);
  rig.run(1);
  const double no_load = arm()->actuators[0].no_load_speed;
  EXPECT_NEAR(rig.rate(), 0.75 * no_load, 1e-3 * no_load);
}

TEST(VoltageSag, GoesOnWithTimeAtItsSlope) {
  Rig rig(arm(), {effect("voltage_sag", {{"drop", 0}, {"slope", 0.05}})});
  rig.run(2);
  rig.command.angle[0] = 3;
  rig.step();
  EXPECT_NEAR(rig.motorTorque(), 0.9 * mostTorque(), 1e-3);
}

TEST(ThermalDerating, TakesTorqueAsTheHeatOfItsSquareBuildsUp) {
  constexpr double kPart = 0.4, kTime = 5, kTorque = 3;  // -, [s], [N m]
  EffectChain chain =
      chainOf(*arm(), {effect("thermal_derating", {{"part", kPart}, {"time", kTime}})});
  const JointArray<double> zero(1), torque(1, kTorque);
  DriveTerms terms;
  for (int i = 0; i < 2000; ++i) {  // 4 s
    chain.alterDrive({{}, 0.002, zero, zero, zero, zero, torque, zero}, terms);
  }
  const double warmth = std::pow(kTorque / mostTorque(), 2) * (1 - std::exp(-4 / kTime));
  EXPECT_NEAR(terms.torque_part[0], 1 - kPart * warmth, 1e-12);
}

// The gear helps to hold: the cold motor is at its limit already, and holds 0.9 of stall torque
// over efficiency until a tenth of it is gone, after ln(1.5) of the time.
TEST(ThermalDerating, DropsALoadThatTheColdMotorHeld) {
  Rig rig(arm(), {effect("thermal_derating", {{"part", 0.3}, {"time", 4}})});
  rig.pull = 0.9 * arm()->actuators[0].stall_torque / arm()->actuators[0].efficiency;
  rig.run(0.3 * 4);
  const double held = rig.angle();
  EXPECT_LT(held, 0.2);
  rig.run(0.08 * 4);
  EXPECT_NEAR(rig.angle(), held, 1e-4);
  rig.run(0.3 * 4);
  EXPECT_GT(rig.angle(), held + 0.05);
}

TEST(MotorInertia, SlowsWhatTheRotorMustFollow) {
  auto model = freeRod(kMass, kLength);
  model->actuators[0].rotor_inertia = 0.01;
  Rig rig(model, {effect("motor_inertia", {{"part", 0.5}})});
  rig.pull = 0.1;
  rig.run(0.1);
  const double inertia = kMass * kLength * kLength + 1e-6 + 0.015;
  EXPECT_NEAR(rig.rate(), 0.1 * rig.pull / inertia, 1e-9);
}

TEST(LinkMass, ChangesTheSagByItsShare) {
  const auto sagOf = [](double part) {
    Rig rig(arm(), {effect("link_mass", {{"part", part}})}, kGravity);
    rig.run(2);
    return rig.angle();
  };
  const double nominal = sagOf(0);
  EXPECT_NEAR(nominal, kWeight / kp(), 1e-6);
  EXPECT_NEAR(sagOf(0.2), 1.2 * nominal, 2e-6);
  EXPECT_NEAR(sagOf(-0.5), 0.5 * nominal, 2e-6);
}

TEST(LinkCom, ChangesTheSagByItsLever) {
  Rig rig(arm(), {effect("link_com", {{"x", 0.05}})}, kGravity);
  rig.run(2);
  EXPECT_NEAR(rig.angle(), kMass * kGravity * (kLength + 0.05) / kp(), 2e-6);
}

TEST(Payload, WeighsAtItsPlaceAndSwingsByHuygensAndSteiner) {
  const EffectSetting load = effectOn(0, "payload", {{"mass", 0.3}, {"x", 0.4}});
  Rig rests(arm(), {load}, kGravity);
  rests.run(2);
  const double torque = kGravity * (kMass * kLength + 0.3 * 0.4);
  EXPECT_NEAR(rests.angle(), torque / kp(), 2e-6);

  Rig turns(freeRod(kMass, kLength), {load});
  turns.pull = 0.1;
  turns.run(0.1);
  const double inertia = kMass * kLength * kLength + 1e-6 + 0.3 * 0.4 * 0.4;
  EXPECT_NEAR(turns.rate(), 0.1 * 0.1 / inertia, 1e-9);
}

TEST(Payload, RidesOnTheRootWhereNoJointIsNamed) {
  Rig rig(arm(), {effect("payload", {{"mass", 0.3}})});
  EXPECT_DOUBLE_EQ(rig.plan().model.bodies[0].mass, 1.3);
  EXPECT_DOUBLE_EQ(rig.plan().model.bodies[1].mass, kMass);
}

TEST(GravityScale, ScalesTheSag) {
  Rig rig(arm(), {effect("gravity_scale", {{"scale", 1.1}})}, kGravity);
  rig.run(2);
  EXPECT_NEAR(rig.angle(), 1.1 * kWeight / kp(), 2e-6);
}

TEST(ProcessNoise, HasItsSizeAndItsMemory) {
  constexpr double kSd = 0.05, kTime = 0.1, kStep = 0.002;
  EffectChain chain = chainOf(*arm(), {effect("process_noise", {{"sd", kSd}, {"time", kTime}})});
  const JointArray<double> zero(1);
  std::vector<double> torque;
  for (int i = 0; i < 200000; ++i) {
    DriveTerms terms;
    chain.alterDrive({{}, kStep, zero, zero, zero, zero, zero, zero}, terms);
    torque.push_back(terms.disturbance[0]);
  }
  const std::size_t lag = 50;  // one correlation time
  double square = 0, product = 0;
  for (std::size_t i = 0; i + lag < torque.size(); ++i) {
    square += torque[i] * torque[i];
    product += torque[i] * torque[i + lag];
  }
  const double count = static_cast<double>(torque.size() - lag);
  // 400 s hold 2000 independent values: 1.6 % of one standard deviation; five of these.
  EXPECT_NEAR(std::sqrt(square / count), kSd, 0.08 * kSd);
  EXPECT_NEAR(product / square, std::exp(-1.0), 0.1);
}

}  // namespace
}  // namespace nao::sim::test
