// Robots against robots, balls and themselves.
#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "core/shape_gap.h"
#include "sim/touching.h"
#include "sim/world.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

// How deep any two solids may be in each other while ten Naos fall onto each other: two that meet
// with 2 m/s, a fall from standing, are within a step by 4 mm; the rest is pressing.
constexpr double kPileUpLimit = 0.012;  // [m]

JointCommand posture(const RobotModel& model, const char* name, double stiffness) {
  return {model.findPosture(name)->angle, JointArray<double>(model.jointCount(), stiffness)};
}

// The greatest overlap [m] of solids in the world now: of all robots, and of each with itself.
double overlap(const World& world) {
  const SceneFrame scene = world.scene();
  std::vector<CollisionBody> solids;
  std::vector<std::vector<BodyMotion>> motions;
  for (const SceneFrame::Robot& robot : scene.robots) {
    std::vector<BodyMotion> motion;
    for (const Pose& X : robot.X_WB) {
      motion.push_back({X.linear(), X.translation(), Vec3::Zero(), Vec3::Zero()});
    }
    solids.emplace_back(*robot.model);
    solids.back().update(motion);
    motions.push_back(motion);
  }
  double deepest = 0;
  const auto check = [&](std::size_t a, int i, std::size_t b, int j) {
    const auto m = static_cast<std::size_t>(i);
    const auto n = static_cast<std::size_t>(j);
    const ShapeGap gap = calcShapeGap(solids[a].solid(m).shape, solids[a].calcPose(m, motions[a]),
                                      solids[b].solid(n).shape, solids[b].calcPose(n, motions[b]));
    deepest = std::max(deepest, -gap.distance);
  };
  for (std::size_t a = 0; a < solids.size(); ++a) {
    for (const auto& pair : solids[a].pairs()) check(a, pair.a, a, pair.b);
    for (std::size_t b = a + 1; b < solids.size(); ++b) {
      for (std::size_t i = 0; i < solids[a].size(); ++i) {
        for (std::size_t j = 0; j < solids[b].size(); ++j) {
          check(a, static_cast<int>(i), b, static_cast<int>(j));
        }
      }
    }
  }
  return deepest;
}

// Momentum [kg m/s] of all bodies.
Vec3 momentum(const RobotBody& robot) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < robot.motion().size(); ++i) {
    const BodyMotion& m = robot.motion()[i];
    const Body& body = robot.model().bodies[i];
    sum += body.mass * (m.v_WB + m.w_WB.cross(m.R_WB * body.p_BoBcm));
  }
  return sum;
}

// Thrown at each other in space. In the mode Rk4, which itself keeps momentum to the fourth order.
TEST(Bump, TwoRobotsKeepTheirMomentum) {
  auto world = test::flatWorld();
  world->gravity = 0;
  world->balls.clear();
  const auto model = test::robot("nao_h21_v33_ideal");
  RobotBody first({*model, *world}, Mode::Rk4);
  RobotBody second({*model, *world}, Mode::Rk4);
  const std::vector<RobotBody*> robots{&first, &second};
  Touching touching(*world);
  const JointCommand command = posture(*model, "StandInit", 1);
  for (RobotBody* robot : robots) {
    touching.add(robot->model());
    robot->place({robot == &first ? 0.0 : 0.3, 0.03, robot == &first ? 0.0 : 2.5}, command.angle);
    TreeState state = robot->tree();
    state.q[6] += 10;
    state.u[3] = robot == &first ? 1.0 : 0.2;
    robot->setTree(state);
  }
  const Vec3 before = momentum(first) + momentum(second);
  const Vec3 first_before = momentum(first);
  std::vector<BallState> no_balls;
  std::vector<std::vector<ExternalForce>> forces;
  for (int k = 0; k < 500; ++k) {
    touching.step(robots, no_balls, 1e-3, forces);
    for (std::size_t r = 0; r < 2; ++r) robots[r]->step(command, nullptr, forces[r], 1e-3);
  }
  EXPECT_GT((momentum(first) - first_before).norm(), 1);  // they did meet
  EXPECT_LT((momentum(first) + momentum(second) - before).norm(), 1e-6 * before.norm());
}

TEST(Bump, BothSidesGetOppositeForces) {
  auto world = test::flatWorld();
  const auto model = test::robot("nao_h21_v33");
  world->gravity = 0;
  World pair(world, {{"a", model, {0, 0, 0}}, {"b", model, {0.25, 0, M_PI}}}, 2ms);
  pair.push(0, Vec3(20, 0, 0), 100ms);
  bool met = false;
  for (int k = 0; k < 200; ++k) {
    pair.step();
    Vec3 sum = Vec3::Zero();
    double size = 0;
    for (const TouchForce& force : pair.contacts().forces) {
      if (force.p_W.z() < 0.02) continue;  // the ground's
      sum += force.f_W;
      size += force.f_W.norm();
    }
    met = met || size > 1;
    ASSERT_LE(sum.norm(), 1e-12 * size);
  }
  EXPECT_TRUE(met);
}

TEST(SelfCollision, AnArmDrivenIntoTheTorsoStopsAtItsSurface) {
  const auto model = test::robot("nao_h21_v33_ideal");
  World world(test::flatWorld(), {{"nao", model, {}}}, 2ms);
  JointCommand command = posture(*model, "StandZero", 1);
  world.placeRobot(0, {}, &command.angle);
  command.angle[*model->findJoint("LShoulderPitch")] = 1.0;
  command.angle[*model->findJoint("LShoulderRoll")] = -0.3;
  command.angle[*model->findJoint("LElbowYaw")] = -0.3;
  command.angle[*model->findJoint("LElbowRoll")] = -1.5;
  double pressed = 0;
  double deepest = 0;
  for (int k = 0; k < 1500; ++k) {
    if (k % 5 == 0) world.setCommand(0, command);
    world.step();
    deepest = std::max(deepest, overlap(world));
    for (const TouchForce& force : world.contacts().forces) {
      const std::string& name = model->bodies[static_cast<std::size_t>(force.body)].name;
      if (name == "LElbowRoll") pressed = std::max(pressed, force.f_W.norm());
    }
  }
  EXPECT_GT(pressed, 2);      // [N] it does press
  EXPECT_LT(deepest, 0.003);  // [m]
  EXPECT_LT(overlap(world), 0.001);
}

TEST(SelfCollision, AStandingNaoTouchesItselfNowhere) {
  for (const char* name : {"nao_h21_v33", "nao_h25_v50"}) {
    const auto model = test::robot(name);
    World world(test::flatWorld(), {{"nao", model, {}}}, 2ms);
    for (const char* pose : {"Stand", "StandInit", "StandZero", "Crouch", "Sit"}) {
      if (!model->findPosture(pose)) continue;
      const JointCommand command = posture(*model, pose, 1);
      world.placeRobot(0, {}, &command.angle);
      world.setCommand(0, command);
      world.step();
      EXPECT_EQ(overlap(world), 0) << name << " " << pose;
    }
  }
}

TEST(PileUp, TenNaosOnAHeapStayApart) {
  const auto model = test::robot("nao_h21_v33");
  std::vector<RobotSetup> setups;
  for (int i = 0; i < 10; ++i) setups.push_back({"nao" + std::to_string(i), model, {}});
  World world(test::flatWorld(), setups, 2ms);
  Random random(3);
  std::vector<JointCommand> commands;
  for (std::size_t i = 0; i < 10; ++i) {
    commands.push_back(posture(*model, "StandInit", 0.8));
    for (double& angle : commands.back().angle) angle += random.uniform(-0.05, 0.05);
    const double turn = 2 * M_PI / 10 * static_cast<double>(i);
    world.placeRobot(i, {0.6 * std::cos(turn), 0.6 * std::sin(turn), turn}, &commands.back().angle);
    world.push(i, 40 * Vec3(-std::cos(turn), -std::sin(turn), 0), 400ms);  // all fall inwards
  }
  ASSERT_EQ(overlap(world), 0);
  double deepest = 0;
  double into_ground = 0;
  for (int k = 0; k < 2500; ++k) {
    if (k % 5 == 0) {
      for (std::size_t i = 0; i < 10; ++i) world.setCommand(i, commands[i]);
    }
    world.step();
    ASSERT_TRUE(world.healthy());
    if (k % 10 == 0) deepest = std::max(deepest, overlap(world));
    for (std::size_t i = 0; i < 10; ++i) {
      into_ground = std::max(into_ground, world.penetration(i));
    }
  }
  RecordProperty("deepest_mm", std::to_string(1000 * deepest));
  EXPECT_GT(deepest, 0.0005);  // it is a heap
  EXPECT_LT(deepest, kPileUpLimit);
  EXPECT_LT(into_ground, 0.03);
}

TEST(PileUp, ABallPressedBetweenTwoRobotsStaysBetweenThem) {
  auto model = test::flatWorld();
  model->balls.clear();
  model->balls.push_back({});
  const auto nao = test::robot("nao_h21_v33");
  World world(model, {{"a", nao, {}}, {"b", nao, {}}}, 2ms);
  const JointCommand command = posture(*nao, "StandInit", 1);
  for (std::size_t i = 0; i < 2; ++i) {
    world.placeRobot(i, {i ? 0.30 : 0.0, 0.05 * (i ? 1 : -1), i ? M_PI : 0.0}, &command.angle);
  }
  world.placeBall(0, Vec3(0.15, 0, 0.0325), Vec3::Zero());
  world.push(0, Vec3(15, 0, 0), 1000ms);
  world.push(1, Vec3(-15, 0, 0), 1000ms);
  double fastest = 0;
  Vec3 last = world.scene().balls[0].p_W;
  for (int k = 0; k < 1500; ++k) {
    if (k % 5 == 0) {
      for (std::size_t i = 0; i < 2; ++i) world.setCommand(i, command);
    }
    world.step();
    ASSERT_TRUE(world.healthy());
    const Vec3 p_W = world.scene().balls[0].p_W;
    fastest = std::max(fastest, (p_W - last).norm() / 2e-3);
    last = p_W;
    ASSERT_GT(p_W.z(), 0.0325 - 0.005);  // [m] never pressed into the floor
  }
  EXPECT_LT(fastest, 5);  // [m/s] nothing shoots it away
}

}  // namespace
}  // namespace nao::sim
