#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <ostream>

#include "core/shape_gap.h"
#include "sim/collision_body.h"
#include "sim/world.h"
#include "tests/support/models.h"
#include "tests/support/shape_gap.h"

// Every robot of this project, and some of others, in the world.
namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

World worldWith(std::shared_ptr<const RobotModel> model) {
  return World(test::flatWorld(), {{"robot", std::move(model), {}}}, 2ms);
}

JointCommand posture(const RobotModel& model, const std::string& name) {
  return {model.findPosture(name)->angle, JointArray<double>(model.jointCount(), 1)};
}

// Sends the command every cycle, as motors want it.
void hold(World& world, const JointCommand& command, Duration duration) {
  for (const SimTime end = world.now() + duration; world.healthy() && world.now() < end;) {
    world.setCommand(0, command);
    for (Duration t{}; t < world.robot(0).model->cycle && world.now() < end;) {
      world.step();
      t += world.stepSize();
    }
  }
}

Vec3 root(const World& world) { return world.scene().robots[0].X_WB[0].translation(); }

// The collision solids as they touch here, beside tests/core/robot_collision_test.cc.
TEST(EveryRobot, TouchesItselfInNoPosture) {
  for (const char* name : {"nao_h21_v33", "nao_h21_v40", "nao_h25_v33", "nao_h25_v40",
                           "nao_h25_v50", "nao_h25_v60", "spider", "arm"}) {
    const auto model = test::robot(name);
    for (const Posture& posture : model->postures) {
      const auto X_RB = test::bodyPoses(*model, posture.angle);
      const CollisionBody solids(*model);
      for (const CollisionBody::Pair& pair : solids.pairs()) {
        const auto& a = solids.solid(static_cast<std::size_t>(pair.a));
        const auto& b = solids.solid(static_cast<std::size_t>(pair.b));
        const Pose X_RA = X_RB[static_cast<std::size_t>(a.body)] * a.shape.X_BS;
        const Pose X_RBb = X_RB[static_cast<std::size_t>(b.body)] * b.shape.X_BS;
        EXPECT_GT(calcShapeGap(a.shape, X_RA, b.shape, X_RBb).distance, 0.0005)
            << name << " " << posture.name << ": "
            << model->bodies[static_cast<std::size_t>(a.body)].name << " and "
            << model->bodies[static_cast<std::size_t>(b.body)].name;
      }
    }
  }
}

struct Stance {
  const char* robot;
  const char* posture;
};

void PrintTo(const Stance& one, std::ostream* out) { *out << one.robot << ' ' << one.posture; }

class EveryRobotStands : public testing::TestWithParam<Stance> {};

// 2 mm: a stride is 40 mm, so nothing that walks would notice.
TEST_P(EveryRobotStands, WhereItWasPut) {
  const auto model = test::robot(GetParam().robot);
  World world = worldWith(model);
  const JointCommand command = posture(*model, GetParam().posture);
  world.placeRobot(0, {}, &command.angle);
  hold(world, command, 1000ms);  // the legs give way under the weight
  const Vec3 before = root(world);
  hold(world, command, 5000ms);
  EXPECT_TRUE(world.healthy());
  EXPECT_LT((root(world) - before).norm(), 2e-3);
  EXPECT_GT(world.scene().robots[0].X_WB[0].linear()(2, 2), std::cos(0.15));  // StandInit leans 0.1
  EXPECT_LT(world.penetration(0), 1e-3);
}

INSTANTIATE_TEST_SUITE_P(
    Robots, EveryRobotStands,
    testing::Values(Stance{"nao_h21_v33", "Crouch"}, Stance{"nao_h21_v33_ideal", "Crouch"},
                    Stance{"nao_h21_v33_ideal", "StandInit"}, Stance{"nao_h21_v40", "Crouch"},
                    Stance{"nao_h21_v40", "StandInit"}, Stance{"nao_h25_v33", "Crouch"},
                    Stance{"nao_h25_v33", "StandInit"}, Stance{"nao_h25_v40", "Crouch"},
                    Stance{"nao_h25_v40", "StandInit"}, Stance{"nao_h25_v50", "Crouch"},
                    Stance{"nao_h25_v60", "Crouch"}, Stance{"nao_h25_v60", "StandInit"},
                    Stance{"nao_h25_v60", "Stand"}, Stance{"spider", "Rest"},
                    Stance{"spider", "Stand"}, Stance{"spider", "Tall"}),
    [](const auto& test) {
      return std::string(test.param.robot) + "_" + std::string(test.param.posture);
    });

TEST(Spider, GetsUpFromItsBelly) {
  const auto model = test::robot("spider");
  World world = worldWith(model);
  const JointCommand rest = posture(*model, "Rest");
  const JointCommand stand = posture(*model, "Stand");
  const double low = root(world).z();
  JointCommand command = rest;
  for (int k = 1; k <= 100; ++k) {  // in one second
    for (std::size_t j = 0; j < model->jointCount(); ++j) {
      command.angle[j] = rest.angle[j] + 0.01 * k * (stand.angle[j] - rest.angle[j]);
    }
    hold(world, command, 10ms);
  }
  hold(world, stand, 500ms);
  EXPECT_NEAR(low, 0.025, 1e-3);  // half of its thorax
  // 100 mm sin(1.1) - 70 mm sin(0.4) + the tip's 10 mm, less what servos and floor give way:
  // a sixth of the weight, 3.5 N, at 110 mm from the femur's servo bends it by 13 mrad, 1.4 mm,
  // and at 45 mm from the tibia's by 5 mrad, 0.2 mm; the floor 0.1 mm.
  EXPECT_NEAR(root(world).z(), 0.0718 - 0.0017, 6e-4);
}

// The torque of gravity [N m] on each hinge, where the bodies are now.
std::vector<double> gravityTorques(const RobotModel& model, const std::vector<Pose>& X_WB) {
  std::vector<double> torque(model.coordinates.size(), 0);
  for (std::size_t b = 1; b < model.bodies.size(); ++b) {
    const Vec3 weight(0, 0, -9.80665 * model.bodies[b].mass);
    const Vec3 centre = X_WB[b] * model.bodies[b].p_BoBcm;
    for (int i = static_cast<int>(b); i > 0; i = model.bodies[static_cast<std::size_t>(i)].parent) {
      const auto hinge = static_cast<std::size_t>(i);
      const Vec3 axis = X_WB[hinge].linear() * model.bodies[hinge].axis;
      torque[hinge - 1] += axis.dot((centre - X_WB[hinge].translation()).cross(weight));
    }
  }
  return torque;
}

// At rest the servo's pull is the load: kp (command - angle) = - torque of gravity.
TEST(Arm, SagsByTorqueOverGain) {
  const auto model = test::robot("arm");
  for (const char* name : {"Up", "Ready", "Reach"}) {
    World world = worldWith(model);
    const JointCommand command = posture(*model, name);
    world.placeRobot(0, {}, &command.angle);
    hold(world, command, 3000ms);
    const auto load = gravityTorques(*model, world.scene().robots[0].X_WB);
    const SensorFrame frame = world.readSensors(0);
    double largest = 0;
    for (std::size_t j = 0; j < model->jointCount(); ++j) {
      const double pull = model->actuators[j].kp * (command.angle[j] - frame.angle[j]);
      EXPECT_NEAR(pull, -load[j], 1e-6) << name << ": " << model->actuators[j].name;
      largest = std::max(largest, std::abs(load[j]));
    }
    EXPECT_EQ(largest < 1e-9, std::string(name) == "Up") << largest;  // [N m] it does carry itself
    EXPECT_EQ(root(world), Vec3::Zero());
  }
}

TEST(Arm, RestsStraightUpWithMotorsOff) {
  World world = worldWith(test::robot("arm"));
  for (int k = 0; k < 1000; ++k) world.step();
  const SensorFrame frame = world.readSensors(0);
  for (const double angle : frame.angle) EXPECT_LT(std::abs(angle), 1e-9);
}

class RobotsOfOthers : public testing::TestWithParam<const char*> {};

TEST_P(RobotsOfOthers, FallOrStandWithoutBlowingUp) {
  const std::string file = std::string(NAO_SOURCE_DIR "/../shared/models/") + GetParam();
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no " << file;
  const auto model = loadRobotModel("", file);
  World world = worldWith(model);
  hold(world, posture(*model, "Zero"), 2000ms);
  ASSERT_TRUE(world.healthy());
  EXPECT_LT(root(world).head<2>().norm(), 1);  // [m] it fell, it did not fly
  EXPECT_GT(root(world).z(), 0);
  EXPECT_LT(root(world).z(), 0.6);
  EXPECT_LT(world.penetration(0), 0.01);
}

INSTANTIATE_TEST_SUITE_P(Urdf, RobotsOfOthers,
                         testing::Values("Aibo.urdf", "darwin.urdf", "naoV32_no_mesh.urdf"),
                         [](const auto& test) {
                           const std::string name = test.param;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace nao::sim
