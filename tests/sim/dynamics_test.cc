// Laws: what the step computes is what Simbody computes, and what a textbook says.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "sim/multibody.h"
#include "sim/robot_body.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

TreeState randomState(const Multibody& multibody, Random& random) {
  TreeState state = multibody.zeroState();
  for (auto& u : state.u) u = random.uniform(-3, 3);
  const int root = multibody.rootPositionCount();
  for (int i = 0; i < root; ++i) state.q[i] = random.normal();
  if (root) state.q.head<4>().normalize();
  for (int i = root; i < state.q.size(); ++i) state.q[i] = random.uniform(-1, 1);
  return state;
}

class NaoDynamics : public testing::TestWithParam<const char*> {};

TEST_P(NaoDynamics, MassMatrixIsSimbodys) {
  const auto model = test::robot(GetParam());
  Multibody multibody(*model, 9.80665);
  TreeDynamics dynamics(*model);
  TreeMatrix matrix(dynamics.parents());
  Random random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const TreeState state = randomState(multibody, random);
    multibody.setState(state);
    dynamics.setState(state);
    dynamics.calcMassMatrix(matrix);
    const Eigen::MatrixXd oracle = multibody.calcMassMatrix();
    double worst = 0;
    for (int i = 0; i < matrix.size(); ++i) {
      for (int j = i; j >= 0; j = matrix.parent(j)) {
        worst = std::max(worst, std::abs(matrix.at(i, j) - oracle(i, j)));
      }
    }
    EXPECT_LT(worst, 1e-12 * oracle.cwiseAbs().maxCoeff());  // rounding of some 30 additions
  }
}

TEST_P(NaoDynamics, PosesAndVelocitiesAreSimbodys) {
  const auto model = test::robot(GetParam());
  Multibody multibody(*model, 9.80665);
  TreeDynamics dynamics(*model);
  std::vector<BodyMotion> expected;
  Random random(5);
  for (int trial = 0; trial < 20; ++trial) {
    const TreeState state = randomState(multibody, random);
    multibody.setState(state);
    multibody.calcMotion(expected);
    dynamics.setState(state);
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const BodyMotion& found = dynamics.motion()[i];  // rounding of some ten additions
      EXPECT_LT((found.p_WB - expected[i].p_WB).norm(), 1e-13);
      EXPECT_LT((found.R_WB - expected[i].R_WB).norm(), 1e-13);
      EXPECT_LT((found.v_WB - expected[i].v_WB).norm(), 1e-12);
      EXPECT_LT((found.w_WB - expected[i].w_WB).norm(), 1e-12);
    }
  }
}

TEST_P(NaoDynamics, BodyVelocitiesAreTheirPosesRatesOfChange) {
  const auto model = test::robot(GetParam());
  Multibody multibody(*model, 9.80665);
  Random random(4);
  TreeState state = randomState(multibody, random);
  std::vector<BodyMotion> now, later;
  multibody.setState(state);
  multibody.calcMotion(now);
  constexpr double kStep = 1e-7;  // the error of the difference is about kStep * a / 2, a ~ 100
  const Eigen::Vector4d q = state.q.head<4>();
  const Vec3 w = state.u.head<3>();
  state.q.head<4>() +=
      kStep / 2 * Eigen::Vector4d(-w.dot(q.tail<3>()), 0, 0, 0) +
      kStep / 2 * (Eigen::Vector4d() << 0, q[0] * w + w.cross(Vec3(q.tail<3>()))).finished();
  state.q.tail(state.q.size() - 4) += kStep * state.u.tail(state.u.size() - 3);
  multibody.setState(state);
  multibody.calcMotion(later);
  for (std::size_t i = 0; i < now.size(); ++i) {
    EXPECT_LT(((later[i].p_WB - now[i].p_WB) / kStep - now[i].v_WB).norm(), 1e-4);
    const Mat3 rate = (later[i].R_WB - now[i].R_WB) / kStep * now[i].R_WB.transpose();
    EXPECT_LT((Vec3(rate(2, 1), rate(0, 2), rate(1, 0)) - now[i].w_WB).norm(), 1e-4);
  }
}

TEST_P(NaoDynamics, FreeAccelerationIsSimbodys) {
  auto model = std::make_shared<RobotModel>(*test::robot(GetParam()));
  for (Actuator& actuator : model->actuators) {  // bare tree: no rotors, no motors, no ties
    actuator.rotor_inertia = actuator.stall_torque = 0;
    if (actuator.coordinates.size() == 2) actuator.coordinates.pop_back();
  }
  for (Coordinate& coordinate : model->coordinates) coordinate.lower = -(coordinate.upper = 1e3);
  model->coupled_limits.clear();
  RobotBody body({*model, *test::flatWorld()});
  Multibody oracle(*model, test::flatWorld()->gravity);
  JointCommand limp{JointArray<double>(model->jointCount()),
                    JointArray<double>(model->jointCount(), -1.0)};
  Random random(2);
  for (int trial = 0; trial < 20; ++trial) {
    TreeState state = body.tree();
    state = randomState(oracle, random);
    state.q[6] = 10;  // in the air
    body.setTree(state);
    oracle.setState(state);
    const Eigen::VectorXd expected = oracle.calcAcceleration(Eigen::VectorXd::Zero(state.u.size()));
    constexpr double kStep = 1e-3;
    body.step(limp, nullptr, {}, kStep);
    const Eigen::VectorXd found = (body.tree().u - state.u) / kStep;
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-9 * expected.cwiseAbs().maxCoeff());
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, NaoDynamics, testing::Values("nao_h21_v33", "nao_h25_v50"));

TEST(Pendulum, SwingsWithItsPeriod) {
  // Small swings about hanging down: T = 2 pi sqrt(I / (m g l)). The step of 0.1 ms is implicit
  // Euler only in stiff terms; a free pendulum is integrated to first order, hence 0.1 %.
  const auto model = test::pendulum(0.5, 0.2);
  model->actuators[0].stall_torque = 0;  // no motor at all
  RobotBody body({*model, *test::flatWorld()});
  TreeState state = body.tree();
  state.q[0] = M_PI / 2 - 0.05;  // rod along +x at 0; +y turns it down
  body.setTree(state);
  JointCommand limp{JointArray<double>(1), JointArray<double>(1, -1.0)};
  int crossings = 0;
  double first = 0, last = 0, before = -1;
  for (int k = 0; crossings < 11; ++k) {
    body.step(limp, nullptr, {}, 1e-4);
    const double offset = body.angle(toJoint(0)) - M_PI / 2;
    if (before < 0 && offset >= 0 && crossings++ == 0) first = k * 1e-4;
    if (before < 0 && offset >= 0) last = k * 1e-4;
    before = offset;
  }
  const double inertia = 0.5 * 0.2 * 0.2 + 1e-6;
  const double period = 2 * M_PI * std::sqrt(inertia / (0.5 * 9.80665 * 0.2));
  EXPECT_NEAR((last - first) / 10, period * (1 + 0.05 * 0.05 / 16), 1e-3 * period);
}

TEST(Servo, SagsByLoadOverGain) {
  const auto model = test::pendulum(0.5, 0.2);
  RobotBody body({*model, *test::flatWorld()});
  JointCommand stiff{JointArray<double>(1), JointArray<double>(1, 1.0)};
  for (const double step : {1e-3, 2e-3, 5e-3}) {
    body.place({}, JointArray<double>(1));
    for (int k = 0; k < static_cast<int>(3 / step); ++k) body.step(stiff, nullptr, {}, step);
    const double sag = body.angle(toJoint(0));
    // Static law, so no step may change it: kp sag = m g l cos(sag).
    EXPECT_NEAR(sag, 0.5 * 9.80665 * 0.2 * std::cos(sag) / 150, 1e-9) << step;
  }
}

TEST(Servo, GivesNoMoreThanStiffnessAllows) {
  const auto model = test::pendulum(0.5, 0.2);  // 0.98 N m of weight
  JointCommand weak{JointArray<double>(1), JointArray<double>(1)};
  for (const double stiffness : {0.05, 0.15, 0.25}) {  // of 0.7 * 8 N m: 0.28, 0.84, 1.4
    RobotBody body({*model, *test::flatWorld()});
    weak.stiffness[0] = stiffness;
    for (int k = 0; k < 1500; ++k) {
      body.step(weak, nullptr, {}, 2e-3);
      EXPECT_LE(std::abs(body.drive().torque()[0]), stiffness * 0.7 * 8 + 1e-12);
    }
    EXPECT_EQ(body.angle(toJoint(0)) < 0.05, stiffness > 0.1) << stiffness;
  }
}

// Its gear loses 30 %: 0.1 of 8 N m lift 0.56 N m and yield to 1.14; the rod weighs 0.98.
TEST(Servo, HoldsMoreThanItLifts) {
  const auto model = test::pendulum(0.5, 0.2);
  struct Case {
    double stiffness;
    bool holds, lifts;
  };
  for (const Case& c : {Case{0.05, false, false}, {0.1, true, false}, {0.25, true, true}}) {
    const JointCommand weak{JointArray<double>(1), JointArray<double>(1, c.stiffness)};
    for (const double start : {0.0, 0.5}) {  // [rad] level, where it is told to be; below, 0.86 N m
      RobotBody body({*model, *test::flatWorld()});
      body.place({}, JointArray<double>(1, start));
      for (int k = 0; k < 1500; ++k) body.step(weak, nullptr, {}, 2e-3);
      const double angle = body.angle(toJoint(0));
      EXPECT_EQ(angle < start + 0.05, c.holds) << c.stiffness << " from " << start;
      EXPECT_EQ(angle < 0.05, start == 0 ? c.holds : c.lifts) << c.stiffness << " from " << start;
    }
  }
}

TEST(Servo, HoldsWithoutCurrentOnlyWhatItsGearHolds) {
  for (const double mass : {0.15, 0.25}) {  // 0.29 and 0.49 N m; 5 % of 8 N m is 0.4
    RobotBody body({*test::pendulum(mass, 0.2), *test::flatWorld()});
    const JointCommand off{JointArray<double>(1), JointArray<double>(1, 0.0)};
    for (int k = 0; k < 500; ++k) body.step(off, nullptr, {}, 2e-3);
    if (mass < 0.2) {
      EXPECT_NEAR(body.angle(toJoint(0)), 0, 1e-6);
    } else {
      EXPECT_GT(body.angle(toJoint(0)), 0.05);
    }
  }
}

TEST(JointStops, YieldLessThanATenthOfADegreeUnderFullTorque) {
  auto model = test::pendulum(0.05, 0.1);
  model->coordinates[0].upper = 0.3;
  model->actuators[0].stall_torque = 12;  // the strongest Nao motor
  RobotBody body({*model, *test::flatWorld()});
  JointCommand beyond{JointArray<double>(1, 2.0), JointArray<double>(1, 1.0)};
  for (int k = 0; k < 1000; ++k) body.step(beyond, nullptr, {}, 2e-3);
  EXPECT_GT(body.angle(toJoint(0)), 0.3);
  EXPECT_LT(body.angle(toJoint(0)) - 0.3, 0.1 * M_PI / 180);
}

TEST(Fall, FollowsGravity) {
  const auto model = test::block(1, Vec3(0.1, 0.1, 0.1));
  RobotBody body({*model, *test::flatWorld()});
  TreeState state = body.tree();
  state.q[6] = 10;
  body.setTree(state);
  const JointCommand none{JointArray<double>(0), JointArray<double>(0)};
  for (int k = 0; k < 500; ++k) body.step(none, nullptr, {}, 2e-3);
  // Velocity exact; position of semi-implicit Euler falls g t h / 2 = 9.8 mm farther.
  EXPECT_NEAR(body.tree().u[5], -9.80665, 1e-9);
  EXPECT_NEAR(body.tree().q[6], 10 - 9.80665 / 2 - 9.80665 * 1e-3, 1e-9);
}

TEST(Friction, SticksBelowItsLimitAndSlidesAboveIt) {
  const auto model = test::block(1, Vec3(0.2, 0.2, 0.05));
  const auto world = test::flatWorld();
  const JointCommand none{JointArray<double>(0), JointArray<double>(0)};
  const double hold = world->ground.friction * 9.80665;
  for (const double force : {0.8 * hold, 1.5 * hold}) {
    RobotBody body({*model, *world});
    for (int k = 0; k < 250; ++k) body.step(none, nullptr, {}, 2e-3);  // settle
    for (int k = 0; k < 500; ++k) {
      Vec3 low = body.motion()[0].p_WB;
      low.z() = 0;  // no tipping moment
      body.step(none, nullptr, {{0, low, Vec3(force, 0, 0)}}, 2e-3);
    }
    if (force < hold) {  // the anchors' springs give way by F / (4 k) = 69 um, and hold
      EXPECT_NEAR(body.tree().q[4], force / (4 * world->ground.tangential_stiffness), 1e-6);
      EXPECT_LT(std::abs(body.tree().u[3]), 1e-6);
    } else {
      // a = F/m - mu g from the moment it lets go. Until then the ground resists with less than mu
      // g but at least with 4 d v, so it lets go at a speed of mu g / (4 d) at most: that is the
      // most by which it may be ahead after 1 s, and it is never behind.
      const double ahead = body.tree().u[3] - (force - hold);
      EXPECT_GE(ahead, 0);
      EXPECT_LE(ahead, hold / (4 * world->ground.tangential_damping));
    }
  }
}

TEST(Momentum, NoInnerForceMovesTheWhole) {
  const auto model = test::robot("nao_h21_v33");
  auto world = test::flatWorld();
  world->gravity = 0;
  RobotBody body({*model, *world});
  TreeState state = body.tree();
  state.q[6] = 5;
  body.setTree(state);
  JointCommand command{JointArray<double>(model->jointCount()),
                       JointArray<double>(model->jointCount(), 1.0)};
  Random random(3);
  const auto momentum = [&] {
    Vec3 p = Vec3::Zero();
    for (std::size_t i = 0; i < model->bodies.size(); ++i) {
      const BodyMotion& m = body.motion()[i];
      p += model->bodies[i].mass * (m.v_WB + m.w_WB.cross(m.R_WB * model->bodies[i].p_BoBcm));
    }
    return p;
  };
  double worst = 0, fastest = 0;
  for (int k = 0; k < 500; ++k) {
    if (k % 100 == 0) {
      for (std::size_t j = 0; j < model->jointCount(); ++j)
        command.angle[j] = random.uniform(-1, 1);
    }
    body.step(command, nullptr, {}, 2e-3);
    worst = std::max(worst, momentum().norm());
    fastest = std::max(fastest, body.tree().u.tail(20).cwiseAbs().maxCoeff());
  }
  EXPECT_GT(fastest, 2);  // it did thrash
  // u is momentum-exact within a step; M changes along it, which first order sees as O(h).
  EXPECT_LT(worst, 0.05);  // [N s], against about 5 kg * 1 m/s of inner motion
}

}  // namespace
}  // namespace nao::sim
