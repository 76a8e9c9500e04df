#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/effects/rig.h"

namespace nao::sim::test {
namespace {

constexpr double kMass = 0.5;                                  // [kg]
constexpr double kLength = 0.2;                                // [m]
constexpr double kInertia = kMass * kLength * kLength + 1e-6;  // [kg m^2] of tests/support's rod
constexpr double kGravity = 10;                                // [m/s^2]
constexpr double kWeight = kMass * kGravity * kLength;         // [N m] of the level rod
constexpr double kStep = 0.001;                                // [s] of the rig

TEST(CoulombFriction, SlowsAtAConstantRateAndThenHolds) {
  Rig rig(freeRod(kMass, kLength), {effect("coulomb_friction", {{"torque", 0.04}})});
  rig.setSpeed(0, 1);
  rig.run(0.25);
  const double slowing = 0.04 / kInertia;             // 2 rad/s^2
  EXPECT_NEAR(rig.rate(), 1 - 0.25 * slowing, 1e-9);  // a constant force leaves no error
  rig.run(0.5);
  EXPECT_NEAR(rig.rate(), 0, 1e-12);
  EXPECT_NEAR(rig.angle(), 1 / (2 * slowing), 1.0 * kStep);  // Euler: within one step's way
}

TEST(CoulombFriction, HoldsALoadBelowItsBudgetAndLetsGoAbove) {
  Rig holds(freeRod(kMass, kLength), {effect("coulomb_friction", {{"torque", 1.01 * kWeight}})},
            kGravity);
  holds.run(1);
  EXPECT_NEAR(holds.angle(), 0, 1e-5);  // creeps at T / 1e6, as sim/geared_motor.cc says
  Rig slips(freeRod(kMass, kLength), {effect("coulomb_friction", {{"torque", 0.9 * kWeight}})},
            kGravity);
  slips.run(0.1);
  EXPECT_NEAR(slips.rate(), 0.1 * 0.1 * kWeight / kInertia, 0.01);
}

TEST(CoulombFriction, BudgetsOfTwoEntriesAddUp) {
  const EffectSetting half = effect("coulomb_friction", {{"torque", 0.02}});
  Rig two(freeRod(kMass, kLength), {half, half});
  two.setSpeed(0, 1);
  two.run(0.1);
  EXPECT_NEAR(two.rate(), 1 - 0.1 * 0.04 / kInertia, 1e-9);
}

TEST(ViscousFriction, SlowsExponentially) {
  Rig rig(freeRod(kMass, kLength), {effect("viscous_friction", {{"coefficient", 0.05}})});
  rig.setSpeed(0, 2);
  rig.run(1);
  const double decay = 0.05 / kInertia;  // 2.5 1/s
  // Implicit Euler's decay is exp(-c t) (1 + c^2 h t / 2) to first order.
  EXPECT_NEAR(rig.rate(), 2 * std::exp(-decay), 2 * std::exp(-decay) * decay * decay * kStep);
}

TEST(StribeckFriction, FadesWithSpeedAsAGaussian) {
  EffectChain chain =
      chainOf(*freeRod(1, 1), {effect("stribeck_friction", {{"torque", 0.4}, {"speed", 0.1}})});
  const JointArray<double> zero(1);
  for (const double rate : {0.0, 0.05, -0.1, 0.3}) {
    DriveTerms terms;
    const JointArray<double> rates(1, rate);
    chain.alterDrive({{}, 0.001, zero, rates, zero, zero, zero, zero}, terms);
    EXPECT_NEAR(terms.resist_forward[0], 0.4 * std::exp(-rate * rate / 0.01), 1e-15);
    EXPECT_DOUBLE_EQ(terms.resist_backward[0], terms.resist_forward[0]);
  }
}

TEST(StribeckFriction, FadesByAnotherExponentAtTheSameSpeed) {
  EffectChain chain =
      chainOf(*freeRod(1, 1),
              {effect("stribeck_friction", {{"torque", 0.4}, {"speed", 0.1}, {"exponent", 1}})});
  const JointArray<double> zero(1);
  for (const double rate : {0.0, 0.05, -0.1, 0.3}) {
    DriveTerms terms;
    const JointArray<double> rates(1, rate);
    chain.alterDrive({{}, 0.001, zero, rates, zero, zero, zero, zero}, terms);
    EXPECT_NEAR(terms.resist_forward[0], 0.4 * std::exp(-std::abs(rate) / 0.1), 1e-15);
  }
}

TEST(StribeckFriction, HoldsWhatRestsAndLetsGoWhatMoves) {
  const EffectSetting friction =
      effect("stribeck_friction", {{"torque", 1.1 * kWeight}, {"speed", 0.1}});
  Rig rests(freeRod(kMass, kLength), {friction}, kGravity);
  rests.run(0.2);
  EXPECT_NEAR(rests.angle(), 0, 1e-5);
  Rig moves(freeRod(kMass, kLength), {friction}, kGravity);
  moves.setSpeed(0, 1);  // ten times the Stribeck speed: nothing is left of the friction
  moves.run(0.02);
  EXPECT_NEAR(moves.rate(), 1 + 0.02 * kWeight / kInertia, 0.01);
}

// The motor that lifts a rod slowly through level must overcome its weight and the friction, the
// one that lowers it is helped: half the difference is the friction.
TEST(LoadFriction, IsTheSameShareOfEveryLoad) {
  constexpr double kShare = 0.2;
  constexpr double kRate = 0.2;  // [rad/s]
  for (const double mass : {0.5, 1.0}) {
    std::vector<double> torque;
    for (const double direction : {1.0, -1.0}) {
      Rig rig(nao::test::pendulum(mass, kLength), {effect("load_friction", {{"share", kShare}})},
              kGravity);
      const double start = -direction * 0.1;
      rig.body().place({}, JointArray<double>(1, start));
      for (int i = 0; i < 500; ++i) {
        rig.command.angle[0] = start + direction * kRate * i * kStep;
        rig.step();
      }
      torque.push_back(rig.motorTorque());
    }
    const double weight = mass * kGravity * kLength;
    EXPECT_NEAR(torque[0] - torque[1], 2 * kShare * weight, 0.04 * kShare * weight) << mass;
  }
}

// The torque of the motor that moves the rod slowly through level, along its weight or against.
double torqueThroughLevel(const EffectSetting& friction, double mass, double direction) {
  constexpr double kRate = 0.2;  // [rad/s]
  Rig rig(nao::test::pendulum(mass, kLength), {friction}, kGravity);
  const double start = -direction * 0.1;
  rig.body().place({}, JointArray<double>(1, start));
  for (int i = 0; i < 500; ++i) {
    rig.command.angle[0] = start + direction * kRate * i * kStep;
    rig.step();
  }
  return rig.motorTorque();
}

TEST(DirectionalLoadFriction, RubsByOneShareLiftingAndByAnotherLowering) {
  const EffectSetting friction =
      effect("directional_load_friction", {{"motoring", 0.3}, {"braking", 0.1}});
  const double weight = 0.5 * kGravity * kLength;  // towards larger angles
  EXPECT_NEAR(torqueThroughLevel(friction, 0.5, -1), -weight * 1.3, 0.02 * weight);
  EXPECT_NEAR(torqueThroughLevel(friction, 0.5, 1), -weight * 0.9, 0.02 * weight);
}

TEST(DirectionalLoadFriction, OfEqualSharesIsLoadFriction) {
  const EffectSetting equal =
      effect("directional_load_friction", {{"motoring", 0.2}, {"braking", 0.2}});
  for (const double direction : {1.0, -1.0}) {
    EXPECT_DOUBLE_EQ(torqueThroughLevel(equal, 0.5, direction),
                     torqueThroughLevel(effect("load_friction", {{"share", 0.2}}), 0.5, direction));
  }
}

TEST(QuadraticLoadFriction, GrowsWithTheSquareOfTheLoad) {
  constexpr double kCoefficient = 0.1;  // [1/(N m)]
  const EffectSetting friction = effect("quadratic_load_friction", {{"coefficient", kCoefficient}});
  for (const double mass : {0.5, 1.0}) {
    const double weight = mass * kGravity * kLength;
    const double budget = kCoefficient * weight * weight;
    const double difference =
        torqueThroughLevel(friction, mass, 1) - torqueThroughLevel(friction, mass, -1);
    EXPECT_NEAR(difference, 2 * budget, 0.06 * budget) << mass;
  }
}

TEST(FrictionAsymmetry, SlowsOneDirectionOnly) {
  for (const double torque : {0.04, -0.04}) {
    Rig forward(freeRod(kMass, kLength), {effect("friction_asymmetry", {{"torque", torque}})});
    Rig backward(freeRod(kMass, kLength), {effect("friction_asymmetry", {{"torque", torque}})});
    forward.setSpeed(0, 1);
    backward.setSpeed(0, -1);
    forward.run(0.1);
    backward.run(0.1);
    const double lost = 0.1 * 0.04 / kInertia;
    EXPECT_NEAR(forward.rate(), torque > 0 ? 1 - lost : 1, 1e-9);
    EXPECT_NEAR(backward.rate(), torque > 0 ? -1 : -1 + lost, 1e-9);
  }
}

// Under half of its friction's torque it goes on at half of the rate from which on it resists by
// all of it; without creep it sticks. The other way it is free.
TEST(FrictionAsymmetry, MayCreepInsteadOfSticking) {
  constexpr double kTorque = 0.04, kCreep = 0.02;
  const auto rateOf = [&](double creep, double load) {
    Rig rig(freeRod(kMass, kLength),
            {effect("friction_asymmetry", {{"torque", kTorque}, {"creep", creep}}),
             effect("torque_bias", {{"torque", load}})});
    rig.run(0.5);
    return rig.rate();
  };
  EXPECT_NEAR(rateOf(kCreep, kTorque / 2), kCreep / 2, 1e-9);
  EXPECT_NEAR(rateOf(0, kTorque / 2), 0, 1e-6);
  EXPECT_NEAR(rateOf(kCreep, -kTorque / 2), rateOf(0, -kTorque / 2), 1e-9);
}

TEST(CoulombFriction, MayCreepInsteadOfSticking) {
  constexpr double kTorque = 0.04, kCreep = 0.02;
  for (const double way : {1.0, -1.0}) {
    Rig rig(freeRod(kMass, kLength),
            {effect("coulomb_friction", {{"torque", kTorque}, {"creep", kCreep}}),
             effect("torque_bias", {{"torque", way * kTorque / 2}})});
    rig.run(0.5);
    EXPECT_NEAR(rig.rate(), way * kCreep / 2, 1e-9);
  }
}

// Secants of the step before held a joint for good whose creep was as good as none: damping grows
// without end where a rate is nearly nothing, and a step later it is as wrong.
TEST(CoulombFriction, ThatHardlyCreepsIsThatWhichSticks) {
  constexpr double kTorque = 0.04;
  for (const double way : {1.0, -1.0}) {
    const auto rateOf = [&](double creep) {
      Rig rig(freeRod(kMass, kLength),
              {effect("coulomb_friction", {{"torque", kTorque}, {"creep", creep}}),
               effect("torque_bias", {{"torque", way * 1.5 * kTorque}})});
      rig.run(0.1);
      return rig.rate();
    };
    EXPECT_NEAR(rateOf(1e-5), way * 0.1 * 0.5 * kTorque / kInertia, 1e-9);
    EXPECT_NEAR(rateOf(1e-5), rateOf(0), 1e-9);
  }
}

}  // namespace
}  // namespace nao::sim::test
