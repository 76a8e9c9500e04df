// The three modes against each other, and against what is known in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <sstream>

#include "core/random.h"
#include "sim/robot_body.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

std::vector<std::string> shippedRobots() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(NAO_SOURCE_DIR "/robots")) {
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Anywhere near the ground, at any attitude, joints beyond their stops at times.
TreeState randomState(const RobotBody& body, Random& random) {
  TreeState state = body.tree();
  for (auto& u : state.u) u = random.uniform(-3, 3);
  const auto root = state.q.size() - static_cast<long>(body.model().coordinates.size());
  if (root > 0) {
    for (int i = 0; i < 7; ++i) state.q[i] = random.normal();
    state.q.head<4>().normalize();
    state.q[6] = random.uniform(0, 0.5);
  }
  for (auto i = root; i < state.q.size(); ++i) {
    const Coordinate& c = body.model().coordinates[static_cast<std::size_t>(i - root)];
    state.q[i] = random.uniform(std::max(c.lower, -3.0) - 0.02, std::min(c.upper, 3.0) + 0.02);
  }
  return state;
}

JointCommand randomCommand(const RobotModel& model, Random& random) {
  JointCommand command{JointArray<double>(model.jointCount()),
                       JointArray<double>(model.jointCount(), 1.0)};
  for (double& angle : command.angle) angle = random.uniform(-1, 1);
  return command;
}

class EveryRobot : public testing::TestWithParam<std::string> {};

// The fast path's matrices, bias and sparse solve against Simbody's own and a dense solve, under
// the same forces, rotors included. 1e-8 is rounding: 1e-16 times the condition of a mass matrix
// whose entries go from a wrist's 1e-5 to 5 kg.
TEST_P(EveryRobot, SpeedsUpAsInSimbody) {
  const auto model = test::robot(GetParam());
  const auto world = test::flatWorld();
  RobotBody fast({*model, *world}, Mode::Rk4);
  RobotBody oracle({*model, *world}, Mode::Reference);
  Random random(11);
  double worst = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const TreeState state = randomState(fast, random);
    const JointCommand command = randomCommand(*model, random);
    fast.setTree(state);
    oracle.setTree(state);
    const std::vector<ExternalForce> push{{0, Vec3(0.1, 0, 0.2), Vec3(3, -2, 1)}};
    const Eigen::VectorXd expected = oracle.calcAcceleration(command, push);
    const Eigen::VectorXd error = fast.calcAcceleration(command, push) - expected;
    worst = std::max(worst, error.cwiseAbs().maxCoeff() / expected.cwiseAbs().maxCoeff());
  }
  EXPECT_LT(worst, 1e-8);
  std::ostringstream figure;
  figure << worst;
  RecordProperty("worst", figure.str());
}

INSTANTIATE_TEST_SUITE_P(Shipped, EveryRobot, testing::ValuesIn(shippedRobots()),
                         [](const auto& name) { return name.param; });

// The implicit step is consistent: what it makes of a state tends to the acceleration, in the first
// order of the step. Away from ground and stops, whose springs take shorter steps to resolve.
// The reference is without friction, and what a gear loses where it holds is friction.
TEST(ImplicitStep, TendsToTheAccelerationInFirstOrder) {
  const auto model = std::make_shared<RobotModel>(*test::robot("nao_h21_v33"));
  for (Actuator& actuator : model->actuators) actuator.efficiency = 1;
  const auto world = test::flatWorld();
  RobotBody body({*model, *world});
  RobotBody oracle({*model, *world}, Mode::Reference);
  Random random(12);
  TreeState state = randomState(oracle, random);
  state.q[6] = 5;
  for (long i = 7; i < state.q.size(); ++i) {
    const Coordinate& c = model->coordinates[static_cast<std::size_t>(i - 7)];
    state.q[i] = (c.lower + c.upper) / 2;
  }

  for (const Actuator& a : model->actuators) {  // the two halves of one motor turn alike
    if (a.coordinates.size() == 2) state.u[6 + a.coordinates[1]] = state.u[6 + a.coordinates[0]];
  }
  JointCommand command{JointArray<double>(model->jointCount()),
                       JointArray<double>(model->jointCount(), 1.0)};
  for (std::size_t j = 0; j < model->jointCount(); ++j) {
    command.angle[j] = state.q[7 + model->actuators[j].coordinates[0]];
  }
  oracle.setTree(state);
  const Eigen::VectorXd expected = oracle.calcAcceleration(command, {});
  std::vector<double> error;
  for (const double h : {4e-5, 2e-5, 1e-5}) {
    body.setTree(state);
    body.step(command, nullptr, {}, h);
    error.push_back(((body.tree().u - state.u) / h - expected).cwiseAbs().maxCoeff());
  }
  EXPECT_NEAR(error[0] / error[1], 2, 0.1);
  EXPECT_NEAR(error[1] / error[2], 2, 0.1);
}

// A passive arm swinging: the farther from the truth, by the order of each method.
double errorAfterASwing(Mode mode, double h, const TreeState& truth) {
  auto model = std::make_shared<RobotModel>(*test::pendulum(0.5, 0.2));
  model->actuators[0].stall_torque = 0;
  RobotBody body({*model, *test::flatWorld()}, mode);
  const JointCommand limp{JointArray<double>(1), JointArray<double>(1, -1.0)};
  for (int k = 0; k < static_cast<int>(std::lround(0.32 / h)); ++k) body.step(limp, nullptr, {}, h);
  return truth.q.size() ? std::abs(body.tree().q[0] - truth.q[0]) : body.tree().q[0];
}

TEST(Modes, PassiveMotionAgreesToTheOrderOfTheMethod) {
  TreeState truth;
  truth.q.resize(1);
  truth.q[0] = errorAfterASwing(Mode::Reference, 5e-3, {});
  const auto ratio = [&](Mode mode, double h) {
    return errorAfterASwing(mode, h, truth) / errorAfterASwing(mode, h / 2, truth);
  };
  EXPECT_NEAR(ratio(Mode::Implicit, 1e-3), 2, 0.1);
  EXPECT_NEAR(ratio(Mode::Rk4, 2e-2), 16, 3);  // the next order shows at so long a step
  EXPECT_LT(errorAfterASwing(Mode::Rk4, 1e-3, truth), 1e-8);
}

// x = g / c (t - (1 - exp(-c t)) / c) under a = g - c v.
TEST(Modes, FallIsTheClosedFormWithAndWithoutDamping) {
  for (const Mode mode : {Mode::Rk4, Mode::Reference}) {
    for (const double c : {0.0, 0.1}) {
      BodyPlan plan(*test::block(1, Vec3(0.1, 0.1, 0.1)), *test::flatWorld());
      plan.linear_damping = c;
      RobotBody body(plan, mode);
      TreeState state = body.tree();
      state.q[6] = 100;
      body.setTree(state);
      const JointCommand none{JointArray<double>(0), JointArray<double>(0)};
      for (int k = 0; k < 1000; ++k) body.step(none, nullptr, {}, 2e-3);
      const double t = 2;
      const double g = plan.gravity;
      const double fallen = c > 0 ? g / c * (t - (1 - std::exp(-c * t)) / c) : g / 2 * t * t;
      EXPECT_NEAR((100 - body.tree().q[6]) / fallen, 1, 1e-9);
    }
  }
}

// kp sag = m g l cos(sag), whatever the mode.
TEST(Modes, SagIsTheSame) {
  for (const Mode mode : {Mode::Implicit, Mode::Rk4, Mode::Reference}) {
    RobotBody body({*test::pendulum(0.5, 0.2), *test::flatWorld()}, mode);
    const JointCommand stiff{JointArray<double>(1), JointArray<double>(1, 1.0)};
    for (int k = 0; k < 2000; ++k) body.step(stiff, nullptr, {}, 1e-3);
    const double sag = body.angle(toJoint(0));
    EXPECT_NEAR(sag, 0.5 * 9.80665 * 0.2 * std::cos(sag) / 150, 1e-8);
  }
}

// Standing on the ground: the penalty springs and their friction hold in every mode.
TEST(Modes, NaoStands) {
  auto model = std::make_shared<RobotModel>(*test::robot("nao_h21_v33"));
  const JointCommand command{model->findPosture("StandInit")->angle,
                             JointArray<double>(model->jointCount(), 1.0)};
  std::vector<double> height;
  for (const Mode mode : {Mode::Implicit, Mode::Rk4, Mode::Reference}) {
    RobotBody body({*model, *test::flatWorld()}, mode);
    body.place({}, command.angle);
    for (int k = 0; k < 500; ++k) body.step(command, nullptr, {}, 1e-3);
    height.push_back(body.tree().q[6]);
    EXPECT_LT(body.tree().q.segment<2>(4).norm(), 0.01);
  }
  EXPECT_NEAR(height[1], height[0], 1e-4);  // [m] still settling, a tenth of what it settles by
  EXPECT_NEAR(height[2], height[1], 1e-5);
}

}  // namespace
}  // namespace nao::sim
