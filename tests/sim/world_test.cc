#include "sim/world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""us;

World worldWith(std::shared_ptr<const RobotModel> model, Duration step = 2ms) {
  return World(test::flatWorld(), {{"nao", std::move(model), {}}}, step);
}

JointCommand posture(const RobotModel& model, const char* name, double stiffness) {
  return {model.findPosture(name)->angle, JointArray<double>(model.jointCount(), stiffness)};
}

void run(World& world, Duration duration) {
  for (const SimTime end = world.now() + duration; world.now() < end;) world.step();
}

// Sends the command every cycle, as a control side does: motors want an order every 500 ms.
void hold(World& world, const JointCommand& command, Duration duration) {
  for (const SimTime end = world.now() + duration; world.now() < end;) {
    world.setCommand(0, command);
    for (Duration t{}; t < 10ms && world.now() < end; t += world.stepSize()) world.step();
  }
}

Vec3 torso(const World& world) { return world.scene().robots[0].X_WB[0].translation(); }

double tilt(const World& world) {  // [rad] of the torso from upright
  return std::acos(std::min(1.0, world.scene().robots[0].X_WB[0].linear()(2, 2)));
}

// [rad] How far the links of a leg can turn forth or back against its motors.
double halfPlay(const RobotModel& model) {
  double sum = 0;
  for (const EffectSetting& effect : model.effects) {
    if (effect.name != "backlash") continue;
    for (const char* name : {"LHipPitch", "LKneePitch", "LAnklePitch"}) {
      const auto& joints = effect.joints;
      if (std::count(joints.begin(), joints.end(), *model.findJoint(name)) == 0) continue;
      sum += effect.parameters.at("width") / 2;
    }
  }
  return sum;
}

class StandingNao : public testing::TestWithParam<std::tuple<const char*, const char*>> {
 protected:
  std::shared_ptr<const RobotModel> model_ = test::robot(std::get<0>(GetParam()));
  JointCommand command_ = posture(*model_, std::get<1>(GetParam()), 1);
};

TEST_P(StandingNao, StaysWhereItStands) {
  World world = worldWith(model_);
  world.placeRobot(0, {}, &command_.angle);
  const double placed = tilt(world);
  // The legs give way under the weight, the body stops swaying, and tips over within its play.
  hold(world, command_, 4000ms);
  const Vec3 before = torso(world);
  const double tilt_before = tilt(world);
  hold(world, command_, 8000ms);
  EXPECT_LT((torso(world) - before).head<2>().norm(), 1e-3);  // [m] measured: 0.06 mm in 9 s
  EXPECT_LT(std::abs(tilt(world) - tilt_before), 0.1 * M_PI / 180);
  // The legs give way by a degree, and lean within their play; a body that leans bends its servos
  // further, by m g h / k: a fifth.
  EXPECT_NEAR(tilt(world), placed, 1.2 * (1 * M_PI / 180 + halfPlay(*model_)));
  EXPECT_LT(world.penetration(0), 1e-3);
}

TEST_P(StandingNao, FeetCarryItsWeightAndTheUnitFeelsGravity) {
  World world = worldWith(model_);
  world.placeRobot(0, {}, &command_.angle);
  for (int k = 0; k < 500; ++k) {
    hold(world, command_, 10ms);
    world.readSensors(0);
  }
  hold(world, command_, 10ms);
  const SensorFrame frame = world.readSensors(0);
  const double weight = model_->totalMass() * 9.80665;
  EXPECT_NEAR(frame.feet[0].total + frame.feet[1].total, weight, 0.01 * weight);
  EXPECT_NEAR(frame.accelerometer.norm(), 9.80665, 0.01);
  EXPECT_LT(frame.accelerometer.z(), -9.6);
  EXPECT_LT(frame.gyroscope.norm(), 0.01);
  EXPECT_NEAR(std::hypot(frame.angle_x, frame.angle_y), tilt(world), 0.2 * M_PI / 180);
}

INSTANTIATE_TEST_SUITE_P(
    Postures, StandingNao,
    testing::Combine(testing::Values("nao_h21_v33_ideal", "nao_h21_v33", "nao_h25_v50"),
                     testing::Values("Stand", "StandInit", "StandZero", "Crouch")));

TEST(World, LimpNaoStaysInCrouch) {  // as a real one does when it is switched off
  for (const char* name : {"nao_h21_v33", "nao_h25_v50"}) {
    World world = worldWith(test::robot(name));
    run(world, 1000ms);
    const Vec3 before = torso(world);
    run(world, 20000ms);
    EXPECT_LT((torso(world) - before).norm(), 1e-3) << name;
    EXPECT_GT(torso(world).z(), 0.2) << name;
  }
}

TEST(World, LimpNaoCollapsesAndLiesOnTheFloor) {
  const auto model = test::robot("nao_h21_v33");
  World world = worldWith(model);
  JointCommand command = posture(*model, "StandInit", -1);
  world.placeRobot(0, {}, &command.angle);
  world.push(0, Vec3(-20, 3, 0), 200ms);
  hold(world, command, 6000ms);
  EXPECT_LT(torso(world).z(), 0.15);
  EXPECT_GT(torso(world).z(), 0.0);
  EXPECT_LT(world.penetration(0), 0.01);
}

TEST(World, ThrashingNeverBlowsUp) {
  for (const Duration step : {Duration(1ms), Duration(2ms), Duration(5ms)}) {
    const auto model = test::robot("nao_h21_v33");
    World world = worldWith(model, step);
    JointCommand command = posture(*model, "StandInit", 1);
    Random random(7);
    for (int k = 0; k < 50; ++k) {
      for (std::size_t j = 0; j < model->jointCount(); ++j) {
        command.angle[j] = random.uniform(model->actuators[j].lower, model->actuators[j].upper);
      }
      hold(world, command, 200ms);
      ASSERT_TRUE(world.healthy());
      ASSERT_LT(torso(world).norm(), 5);
      ASSERT_LT(world.penetration(0), 0.06);  // [m] measured: 0.012 to 0.048
    }
  }
}

TEST(World, HipYawPitchIsOneMotor) {
  const auto model = test::robot("nao_h21_v33");
  World world = worldWith(model);
  JointCommand command = posture(*model, "StandInit", 1);
  const Joint hip = *model->findJoint("RHipYawPitch");
  EXPECT_EQ(hip, *model->findJoint("LHipYawPitch"));
  const auto& pair = model->actuators[index(hip)].coordinates;
  ASSERT_EQ(pair.size(), 2u);
  for (int k = 0; k < 20; ++k) {
    command.angle[hip] = k % 2 ? -0.5 : 0.3;
    hold(world, command, 100ms);
    const auto X_WB = world.scene().robots[0].X_WB;
    double angle[2];
    for (std::size_t i = 0; i < 2; ++i) {
      const auto body = static_cast<std::size_t>(pair[i]) + 1;
      const Mat3 R = X_WB[0].linear().transpose() * X_WB[body].linear();
      const Eigen::AngleAxisd turn(R);
      angle[i] = turn.angle() * (turn.axis().dot(model->bodies[body].axis) > 0 ? 1 : -1);
    }
    EXPECT_NEAR(angle[0], angle[1], 1e-9);
  }
}

TEST(World, TwoRunsAreIdenticalToTheLastBit) {
  const auto model = test::robot("nao_h25_v50");
  World first = worldWith(model);
  World second = worldWith(model);
  for (World* world : {&first, &second}) {
    hold(*world, posture(*model, "StandZero", 0.8), 700ms);
  }
  EXPECT_EQ(first.hash(), second.hash());
  run(second, 2ms);
  EXPECT_NE(first.hash(), second.hash());
}

TEST(World, GoesOnFromASnapshotBitByBit) {
  const auto model = test::robot("nao_h21_v33");
  World world = worldWith(model);
  hold(world, posture(*model, "StandZero", 0.8), 300ms);
  const auto snapshot = world.snapshot();
  hold(world, posture(*model, "StandInit", 0.8), 500ms);
  World other = worldWith(model);
  other.restore(*snapshot);
  hold(other, posture(*model, "StandInit", 0.8), 500ms);
  EXPECT_EQ(world.hash(), other.hash());
}

// The watchdog of the motor boards: 500 ms after the last order they only brake.
TEST(World, MotorsLetGoWithoutOrders) {
  const auto model = test::robot("nao_h21_v33");
  World world = worldWith(model);
  JointCommand command = posture(*model, "StandInit", 1);
  hold(world, command, 1000ms);
  const Joint head = *model->findJoint("HeadYaw");
  command.angle[head] = 0.5;
  world.setCommand(0, command);
  run(world, 510ms);
  EXPECT_NEAR(world.readSensors(0).angle[head], 0.5, 0.01);
  world.placeRobot(0, {}, &command.angle);
  command.angle[head] = 0;
  world.setCommand(0, command);
  run(world, 400ms);
  EXPECT_NEAR(world.readSensors(0).angle[head], 0, 0.01);
  run(world, 2000ms);
  EXPECT_LT(torso(world).z(), 0.25);  // its legs gave way
}

TEST(World, RefusesAStepThatDoesNotDivideTheCycle) {
  EXPECT_THROW(worldWith(test::robot("nao_h21_v33"), 3ms), InputError);
  EXPECT_THROW(worldWith(test::robot("nao_h21_v33"), 500us), InputError);
}

TEST(World, TwoRobotsDoNotPassThroughEachOther) {
  const auto model = test::robot("nao_h21_v33");
  World world(test::flatWorld(), {{"a", model, {0, 0, 0}}, {"b", model, {0.3, 0, M_PI}}}, 2ms);
  for (std::size_t i = 0; i < 2; ++i) {
    const JointCommand command = posture(*model, "StandInit", 1);
    world.placeRobot(i, {i ? 0.25 : 0.0, 0, i ? M_PI : 0.0}, &command.angle);
  }
  world.push(0, Vec3(40, 0, 0), 500ms);
  double nearest = 1;
  for (int k = 0; k < 1000; ++k) {
    for (std::size_t i = 0; i < 2; ++i) world.setCommand(i, posture(*model, "StandInit", 1));
    world.step();
    const SceneFrame scene = world.scene();
    const double gap =
        (scene.robots[0].X_WB[0].translation() - scene.robots[1].X_WB[0].translation()).norm();
    nearest = std::min(nearest, gap);
  }
  EXPECT_GT(nearest, 0.08);  // two torso spheres of 6 cm radius, pressed together
  EXPECT_GT(std::abs(world.scene().robots[1].X_WB[0].translation().x() - 0.25), 0.01);
}

TEST(World, BallRollsOutAsItsDecelerationSays) {
  auto model = test::flatWorld();
  model->balls.push_back({});
  World world(model, {}, 2ms);
  world.placeBall(0, Vec3::Zero(), Vec3(1, 0, 0));
  run(world, 2000ms);
  // v = v0 exp(-c t), x = v0 / c (1 - exp(-c t)); first order in the step, hence 0.2 %.
  EXPECT_NEAR(world.scene().balls[0].p_W.x(), 2 * (1 - std::exp(-1.0)), 2e-3 * 2);
  EXPECT_NEAR(world.scene().balls[0].p_W.z(), model->balls[0].radius, 1e-9);
}

}  // namespace
}  // namespace nao::sim
