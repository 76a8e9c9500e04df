#include "sim/joint_rig.h"

#include <gtest/gtest.h>

#include <cmath>

#include "sim/effects/catalogue.h"
#include "sim/effects/coupled_stop.h"
#include "sim/world.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

constexpr double kMass = 0.6, kLength = 0.15;  // [kg], [m] of the rod
constexpr double kGravity = 9.80665;           // [m/s^2] of WorldModel
constexpr int kRows = 400;                     // of 10 ms
constexpr int kSettle = 30;                    // rows

double wanted(int row) {
  const double t = 0.01 * std::max(0, row);
  return 0.8 * std::sin(3 * t) + 0.2 * std::sin(11 * t);
}

std::shared_ptr<RobotModel> rod(std::vector<EffectSetting> effects) {
  auto model = nao::test::pendulum(kMass, kLength);
  model->actuators[0].rotor_inertia = 0.007;
  model->actuators[0].efficiency = 0.7;
  model->actuators[0].kp = 40;
  model->effects = std::move(effects);
  return model;
}

struct Truth {
  JointSignals signals;
  std::vector<double> link;  // [rad]
};

Truth runWorld(const std::shared_ptr<RobotModel>& model, Duration step, std::uint64_t seed) {
  WorldOptions options(step);
  options.any_step = true;
  options.seed = seed;
  World world(nao::test::flatWorld(), {{model->name, model, {}}}, options);
  JointArray<double> start(1, wanted(0));
  world.placeRobot(0, {}, &start);
  Truth truth;
  for (int row = -kSettle; row < kRows; ++row) {
    const SensorFrame frame = world.readSensors(0);
    if (row >= 0) {
      truth.signals.angle.push_back(frame.angle[0]);
      truth.signals.current.push_back(frame.current[0]);
      const Mat3 R = world.scene().robots[0].X_WB[1].linear();
      truth.link.push_back(std::atan2(-R(2, 0), R(0, 0)));
    }
    world.setCommand(0, {JointArray<double>(1, wanted(row)), JointArray<double>(1, 1.0)});
    for (long i = 10ms / step; i > 0; --i) world.step();
  }
  return truth;
}

// What the rod asks for, along the angles it really had; its slope is that of gravity.
JointLoad loadOf(const std::vector<double>& link) {
  JointLoad load;
  const double weight = kMass * kGravity * kLength;
  for (const double q : link) {
    load.inertia.push_back(kMass * kLength * kLength + 1e-6);
    load.torque.push_back(-weight * std::cos(q));
    load.slope.push_back(weight * std::sin(q));
    load.reference.push_back(q);
  }
  return load;
}

JointOrders orders() {
  JointOrders all;
  for (int row = 0; row < kRows; ++row) all.angle.push_back(wanted(row));
  return all;
}

double largestDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

// The rig knows the load at every row only and takes it as linear between; over 10 ms at 5 rad/s
// this bends the rod's gravity of 0.9 N m by 3e-4 N m, which 40 N m/rad turn to 1e-5 rad.
constexpr double kAngleTolerance = 2e-5;    // [rad]
constexpr double kCurrentTolerance = 1e-3;  // [A]

void expectAgreement(const std::vector<EffectSetting>& effects,
                     double tolerance = kAngleTolerance) {
  const auto model = rod(effects);
  for (const Duration step : {Duration(1ms), Duration(250'000)}) {
    const Truth truth = runWorld(model, step, 7);
    const JointRig rig(*model, toJoint(0), 10ms, step);
    RigChance chance;
    chance.stream = 7;
    const JointSignals signals =
        rig.run(effects, orders(), loadOf(truth.link), chance, kSettle * 10ms);
    EXPECT_LT(largestDifference(signals.angle, truth.signals.angle), tolerance);
    EXPECT_LT(largestDifference(signals.current, truth.signals.current), kCurrentTolerance);
  }
}

EffectSetting effect(const char* name, std::map<std::string, double> parameters = {}) {
  return {name, std::move(parameters), {}, ""};
}

TEST(JointRig, IsTheWorldOfOneHinge) { expectAgreement({}); }

TEST(JointRig, RubsAsTheWorldDoes) {
  expectAgreement({effect("coulomb_friction", {{"torque", 0.2}}), effect("viscous_friction")});
  expectAgreement({effect("stribeck_friction", {{"torque", 0.2}}), effect("load_friction")});
  expectAgreement({effect("directional_load_friction", {{"braking", 0.05}}),
                   effect("quadratic_load_friction", {{"coefficient", 0.2}})});
}

TEST(JointRig, HasTheWorldsGears) {
  // Where the gear touches depends on the last digits of the load.
  expectAgreement({effect("backlash"), effect("coulomb_friction")}, 1e-4);
  expectAgreement({effect("gear_compliance")});
}

TEST(JointRig, HearsAndReportsAsLateAsTheWorld) {
  expectAgreement({effect("command_latency", {{"delay", 0.0123}}), effect("sensor_delay"),
                   effect("command_filter"), effect("command_hold")});
}

TEST(JointRig, HasTheWorldsServo) {
  // A servo at the edge of its dead band is soft.
  expectAgreement({effect("duty_root")});
  expectAgreement({effect("kp_error"), effect("servo_deadband"), effect("torque_limit"),
                   effect("voltage_sag"), effect("thermal_derating"), effect("encoder_offset")},
                  1e-4);
}

TEST(JointRig, DrawsTheWorldsRandomNumbers) {
  expectAgreement({effect("process_noise", {{"sd", 0.1}})});
  // A reading next to the middle between two counts may fall to either side.
  expectAgreement({effect("encoder_quantum")}, 2 * M_PI / 4096 + 1e-6);
}

TEST(JointRig, MeetsTheWorldsStops) {
  auto model = rod({});
  model->coordinates[0].upper = 0.6;
  const Truth truth = runWorld(model, 1ms, 0);
  EXPECT_LT(*std::max_element(truth.link.begin(), truth.link.end()), 0.61);
  const JointRig rig(*model, toJoint(0), 10ms, 1ms);
  const JointSignals signals = rig.run({}, orders(), loadOf(truth.link), {}, kSettle * 10ms);
  EXPECT_LT(largestDifference(signals.angle, truth.signals.angle), 1e-4);
}

TEST(JointRig, LateOrdersAreOrdersOfALaterTime) {
  const auto model = rod({});
  model->actuators[0].stall_torque = 1000;  // never at its limit: the law is linear
  JointLoad load = loadOf(std::vector<double>(kRows, 0.0));
  const JointRig rig(*model, toJoint(0), 10ms, 1ms);
  const auto anglesAfter = [&](double start) {
    RigChance late;
    late.start = start;
    return rig.run({}, orders(), load, late, 1000ms).angle;  // at rest by then
  };
  const auto now = anglesAfter(0), row = anglesAfter(0.01), ahead = anglesAfter(-0.01);
  const auto half = anglesAfter(0.0005), whole = anglesAfter(0.001);
  for (std::size_t k = 2; k + 2 < now.size(); ++k) {
    EXPECT_NEAR(row[k], now[k - 1], 1e-9);
    EXPECT_NEAR(ahead[k], now[k + 1], 1e-9);
    EXPECT_NEAR(half[k], (now[k] + whole[k]) / 2, 1e-9);
  }
}

TEST(JointRig, ItsTorqueHasTheStatedSpreadWhateverTheCauses) {
  // A joint without servo or gravity adds up its torque: at most a look at its acceleration.
  const auto model = rod({});
  JointLoad load = loadOf(std::vector<double>(kRows, 0.0));
  const JointRig rig(*model, toJoint(0), 10ms, 1ms);
  RigChance chance;
  chance.torque_sd = 0.2;
  chance.torque_time = 0.1;
  double sum = 0, squares = 0;
  int n = 0;
  JointOrders still{std::vector<double>(kRows, 0.0), {}};
  std::fill(load.torque.begin(), load.torque.end(), 0.0);
  std::fill(load.slope.begin(), load.slope.end(), 0.0);
  for (chance.stream = 1; chance.stream <= 40; ++chance.stream) {
    for (const double angle : rig.run({}, still, load, chance, 500ms).angle) {
      sum += angle;
      squares += angle * angle;
      ++n;
    }
  }
  // Slow torques turn the servo by sd / kp; its damping (kd / kp = 38 ms) takes the faster part:
  // variance of a first-order lag T behind a correlation time tau is tau / (tau + T).
  const double expected = 0.2 / 40 * std::sqrt(0.1 / (0.1 + 0.0375));
  EXPECT_NEAR(std::sqrt(squares / n - sum / n * sum / n), expected, 0.1 * expected);
}

TEST(JointRig, OfEffectsThatCannotActOnOneJointNoneDoes) {
  for (const EffectType& type : standardEffects().types()) {
    const bool elsewhere = type.name.rfind("imu", 0) == 0 || type.name.rfind("fsr", 0) == 0 ||
                           type.name == "ground_friction" || type.name == "ground_compliance" ||
                           type.name == "floor_friction" || type.name == "start_pose";
    EXPECT_EQ(actsOnJoint(type), !elsewhere) << type.name;
  }
  const auto model = rod({});
  const JointLoad load = loadOf(std::vector<double>(kRows, 0.0));
  const JointRig rig(*model, toJoint(0), 10ms, 1ms);
  const JointSignals plain = rig.run({}, orders(), load, {}, 100ms);
  EXPECT_EQ(rig.run({effect("imu_bias"), effect("fsr_gain")}, orders(), load, {}, 100ms).angle,
            plain.angle);
  EXPECT_THROW(rig.run({effect("unheard_of")}, orders(), load, {}, 100ms), InputError);
}

// The elbow is told to stretch while its stop comes in as the shoulder rolls, in World and rig.
TEST(JointRig, MeetsAStopThatMovesWithTheJointItHangsOn) {
  auto model = std::make_shared<RobotModel>(*nao::test::robot("arm"));
  std::size_t limited = 0;
  std::optional<Joint> other;
  for (; limited < model->jointCount() && !other; ++limited) {
    other = findCoupledTo(*model, toJoint(limited));
  }
  ASSERT_TRUE(other);
  --limited;
  const Coordinate& hinge =
      model->coordinates[static_cast<std::size_t>(model->actuators[limited].coordinates[0])];
  const double range = hinge.upper - hinge.lower, place = 0.1, slope = 0.4 * range;
  const EffectSetting stop{
      "coupled_stop", {{"upper", slope}, {"place", place}}, {toJoint(limited)}, ""};
  model->effects = {stop};
  const auto bend = [](int row) { return 0.002 * std::max(0, row); };  // [rad] of the other
  JointArray<double> angle(model->jointCount());
  angle[limited] = hinge.upper;
  WorldOptions options(1ms);
  World world(nao::test::flatWorld(), {{model->name, model, {}}}, options);
  world.placeRobot(0, {}, &angle);
  std::map<std::size_t, double> truth;  // by row, where the stop carries all the servo gives
  constexpr double kDeep = 0.1;         // [rad]
  JointOrders orders{std::vector<double>(kRows, hinge.upper), {}};
  JointLoad load;
  load.inertia.assign(kRows, 0.01);
  load.torque = load.slope = load.reference = std::vector<double>(kRows, 0.0);
  const Duration row = model->cycle;
  for (int k = 0; k < kRows; ++k) {
    const SensorFrame frame = world.readSensors(0);
    load.others[model->actuators[index(*other)].name].push_back(frame.angle[*other]);
    const double inside = std::max(0.0, slope * (frame.angle[*other] - place));
    // A motor of 60 N m that is turned back presses a stop of 2e4 N m/rad in by 3 mrad, its gear by
    // as much again, and the stop's damping holds it back.
    if (inside > kDeep) {
      EXPECT_NEAR(frame.angle[limited], hinge.upper - inside, 1e-2) << k;
      truth[static_cast<std::size_t>(k)] = frame.angle[limited];
    }
    angle[*other] = bend(k);
    world.setCommand(0, {angle, JointArray<double>(model->jointCount(), 1.0)});
    for (long i = row / 1ms; i > 0; --i) world.step();
  }
  EXPECT_GT(bend(kRows), place + 0.3);
  const JointRig rig(*model, toJoint(limited), row, 1ms, {model->actuators[index(*other)].name});
  const auto angles = rig.run({stop}, orders, load, {}, 10 * row).angle;
  EXPECT_GT(truth.size(), 100u);
  for (const auto& [k, met] : truth) EXPECT_NEAR(angles[k], met, 1e-3) << k;
}

TEST(JointRig, TakesTheAngleOfTheJointThatLimitsIt) {
  const auto nao = nao::test::robot("nao_h21_v33_ideal");
  const Joint roll = *nao->findJoint("LAnkleRoll");
  const JointRig rig(*nao, roll, 10ms, 1ms, {"LAnklePitch"});
  JointOrders out{std::vector<double>(kRows, 0.0), {}};
  JointLoad load;
  for (int k = 0; k < kRows; ++k) {
    out.angle[static_cast<std::size_t>(k)] = std::min(0.5, 0.005 * k);
    load.others["LAnklePitch"].push_back(-1.0);
    load.inertia.push_back(0.001);
  }
  load.torque = load.slope = load.reference = std::vector<double>(kRows, 0.0);
  const double bent = rig.run({}, out, load, {}, 100ms).angle.back();
  load.others["LAnklePitch"].assign(kRows, 0.0);
  const double straight = rig.run({}, out, load, {}, 100ms).angle.back();
  EXPECT_LT(bent, 0.2);
  EXPECT_GT(straight, 0.3);
}

}  // namespace
}  // namespace nao::sim
