#include "validation/diagnosis/rig/joint_load.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/models.h"
#include "validation/diagnosis/rig/smooth_motion.h"
#include "validation/log/simulated_recording.h"
#include "validation/suspended.h"

namespace nao::validation {
namespace {

TEST(SmoothMotion, KnowsASineAndItsDerivatives) {
  std::vector<double> samples;
  for (int k = 0; k < 200; ++k) samples.push_back(std::sin(0.01 * 12 * k));
  const SmoothMotion motion = smoothed(samples, 0.01, 10, 0.004);
  for (std::size_t k = 20; k < 180; ++k) {
    const double phase = 12 * (0.01 * static_cast<double>(k) + 0.004);
    EXPECT_NEAR(motion.angle[k], std::sin(phase), 1e-3);
    EXPECT_NEAR(motion.rate[k], 12 * std::cos(phase), 0.05);
    EXPECT_NEAR(motion.acceleration[k], -144 * std::sin(phase), 2);
  }
}

TEST(SmoothMotion, PassesOverGaps) {
  std::vector<double> samples;
  for (int k = 0; k < 50; ++k) samples.push_back(k % 7 == 3 ? NAN : 0.02 * k);
  const SmoothMotion motion = smoothed(samples, 0.01, 10);
  for (std::size_t k = 5; k < 45; ++k) {
    EXPECT_NEAR(motion.angle[k], 0.02 * static_cast<double>(k), 1e-9);
    EXPECT_NEAR(motion.rate[k], 2, 1e-9);
  }
}

MeasuredMotion measuredOf(const LogSet& set, const RobotModel& model) {
  const LogRun& run = set.runs.front();
  MeasuredMotion measured;
  measured.dt = toSeconds(model.cycle);
  measured.angle.setZero(static_cast<Eigen::Index>(run.t.size()),
                         static_cast<Eigen::Index>(model.jointCount()));
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    const Column& q = *run.find("q." + model.actuators[j].name);
    for (std::size_t k = 0; k < q.size(); ++k) {
      measured.angle(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(j)) = q[k];
    }
  }
  return measured;
}

RecordingPlan sway(const std::shared_ptr<const RobotModel>& model) {
  RecordingPlan plan;
  plan.model = model;
  plan.repeats = 1;
  plan.motions = {{"sway", Split::Fit, 1, [model](double t) {
                     JointArray<double> angle(model->jointCount());
                     for (std::size_t j = 0; j < angle.size(); ++j) {
                       const double pace = 3 + 0.3 * static_cast<double>(j);
                       angle[j] = 0.15 * (1 - std::cos(pace * t));
                     }
                     return angle;
                   }}};
  return plan;
}

std::vector<JointCommand> ordersOf(const RecordingPlan& plan, const RobotModel& model) {
  std::vector<JointCommand> orders;
  const double cycle = toSeconds(model.cycle);
  for (double t = 0; t <= plan.motions[0].duration + cycle / 2; t += cycle) {
    orders.push_back({plan.motions[0].angles(t), JointArray<double>(model.jointCount(), 1.0)});
  }
  return orders;
}

// In a world with ideal drives a motor's torque is what its rotor and its load take.
void expectMotorTorque(const char* name, double tolerance,
                       const std::vector<EffectSetting>& extra = {}) {
  const auto whole = nao::test::robot("nao_h21_v33_ideal");
  const auto model = std::make_shared<RobotModel>(stripped(suspend(*whole)));
  model->cycle = std::chrono::microseconds(250);  // so that commands are nearly smooth
  const Joint joint = *model->findJoint(name);
  RecordingPlan plan = sway(model);
  plan.extra = extra;
  const LogSet set = recordSimulated(plan);
  const MeasuredMotion measured = measuredOf(set, *model);
  LoadOptions options;
  options.per_row = 1;
  options.bandwidth = 30;
  const sim::JointLoad found =
      calcJointLoad(*model, extra, ordersOf(plan, *model), measured, joint, options);
  const Actuator& motor = model->actuators[index(joint)];
  const double ampere_per_torque = motor.no_load_speed / (21.6 * motor.efficiency);
  const Column& current = *set.runs[0].find("cur." + motor.name);
  const auto column = measured.angle.col(static_cast<Eigen::Index>(index(joint)));
  const SmoothMotion own = smoothed({column.data(), column.data() + column.size()}, 0.00025, 30);
  double squares = 0, weight = 0;
  for (std::size_t k = 400; k + 400 < current.size(); ++k) {
    const double asked =
        found.torque[k] + (found.inertia[k] + motor.rotor_inertia) * own.acceleration[k];
    squares += std::pow(std::abs(asked) - current[k] / ampere_per_torque, 2);
    weight += asked * asked;
  }
  EXPECT_LT(std::sqrt(squares / weight), tolerance) << name;
}

// Commands in stairs of 0.25 ms shake the motor a little.
constexpr double kTorqueTolerance = 0.02;  // of its RMS

TEST(JointLoad, IsWhatTheMotorGives) {
  for (const char* name : {"HeadPitch", "LShoulderPitch", "LHipPitch", "RKneePitch"}) {
    expectMotorTorque(name, kTorqueTolerance);
  }
}

TEST(JointLoad, TurnsBothHipsOfTheMotorTheyShare) {
  expectMotorTorque("LHipYawPitch", kTorqueTolerance);
}

TEST(JointLoad, KnowsOtherMassesAndATiltedBase) {
  expectMotorTorque(
      "LHipPitch", kTorqueTolerance,
      {{"link_mass", {{"part", 0.5}}, {}, ""}, {"ground_tilt", {{"x", 0.0}, {"y", 0.3}}, {}, ""}});
}

TEST(JointLoad, OfAStillRobotIsGravityAndItsSlope) {
  auto model = nao::test::pendulum(0.6, 0.15);
  const MeasuredMotion still{0.01, Eigen::MatrixXd::Constant(50, 1, 0.4)};
  model->cycle = std::chrono::milliseconds(10);
  const std::vector<JointCommand> orders(50,
                                         {JointArray<double>(1, 0.4), JointArray<double>(1, 1.0)});
  const sim::JointLoad found = calcJointLoad(*model, {}, orders, still, toJoint(0), {});
  const double weight = 0.6 * 9.80665 * 0.15;
  EXPECT_NEAR(found.torque[25], -weight * std::cos(0.4), 1e-9);
  EXPECT_NEAR(found.slope[25], weight * std::sin(0.4), 1e-6);
  EXPECT_NEAR(found.inertia[25], 0.6 * 0.15 * 0.15 + 1e-6, 1e-12);
  EXPECT_NEAR(found.reference[25], 0.4, 1e-12);
}

}  // namespace
}  // namespace nao::validation
