// Every sensor against what it must report in closed form.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "sim/battery.h"
#include "sim/motor_heat.h"
#include "sim/sonar.h"
#include "sim/world.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;

Shape box(const Vec3& size, const Vec3& p_W) {
  Shape shape;
  shape.kind = Shape::Kind::Box;
  shape.size = size;
  shape.X_BS = translation(p_W);
  return shape;
}

std::shared_ptr<WorldModel> worldWith(const std::vector<Shape>& things) {
  auto world = std::make_shared<WorldModel>();
  for (const Shape& thing : things) world->obstacles.push_back({"thing", thing, {}});
  return world;
}

JointCommand standing(const RobotModel& model) {
  return {model.findPosture("StandInit")->angle, JointArray<double>(model.jointCount(), 1.0)};
}

// A Nao that stands still, and what it senses after `seconds`.
SensorFrame senseAfter(double seconds, World& world, const JointCommand& command) {
  world.placeRobot(0, world.robot(0).start, &command.angle);
  SensorFrame frame;
  for (int cycle = 0; cycle * 0.01 < seconds; ++cycle) {
    world.setCommand(0, command);
    for (int k = 0; k < 5; ++k) world.step();
    frame = world.readSensors(0);
  }
  return frame;
}

SensorFrame senseAfter(double seconds, World& world) {
  return senseAfter(seconds, world, standing(*world.robot(0).model));
}

World oneNao(std::shared_ptr<WorldModel> model, const char* robot = "nao_h21_v33_ideal") {
  return World(std::move(model), {{"nao", test::robot(robot), {}}}, 2ms);
}

TEST(MotorHeat, RisesAsAFirstOrderSystem) {
  const auto model = test::robot("nao_h21_v33");
  MotorHeat heat(*model);
  JointArray<double> torque(model->jointCount());
  const std::size_t knee = index(*model->findJoint("LKneePitch"));
  torque[knee] = 1.0;
  SensorFrame frame;
  const double end = heat.calcFinalTemperature(knee, 1.0);
  EXPECT_GT(end, 30);
  for (int k = 1; k <= 40000; ++k) {
    heat.sample(torque, 0.01, frame);
    if (k % 10000 != 0) continue;  // exact per cycle, hence rounding alone
    const double t = k * 0.01;
    EXPECT_NEAR(frame.temperature[knee],
                end + (25 - end) * std::exp(-t / MotorHeat::timeConstant()), 1e-9);
  }
  EXPECT_EQ(frame.temperature[0], 25);
  torque[knee] = 0;
  const double hot = frame.temperature[knee];
  heat.sample(torque, 100, frame);
  EXPECT_LT(frame.temperature[knee], hot);
}

// k and R are data-sheet figures seen from the joint: full stall torque draws V / R.
TEST(MotorHeat, StallDrawsWhatTheWindingLets) {
  const auto model = test::robot("nao_h21_v33");
  MotorHeat heat(*model);
  JointArray<double> torque(model->jointCount());
  const std::size_t hip = index(*model->findJoint("LHipRoll"));
  const Actuator& motor = model->actuators[hip];
  torque[hip] = motor.efficiency * motor.stall_torque;
  SensorFrame frame;
  heat.sample(torque, 0.01, frame);
  // RE-Max 24: 59.5 mN m at 21.6 V / 837.8 rad/s = 0.02578 N m/A.
  EXPECT_NEAR(frame.current[hip], 0.0595 / (21.6 / (8000 * 2 * M_PI / 60)), 1e-3);
}

TEST(MotorHeat, WarnsByDegrees) {
  const auto model = test::robot("nao_h21_v33");
  MotorHeat heat(*model);
  JointArray<double> torque(model->jointCount(), 5.0);
  SensorFrame frame;
  std::uint8_t before = 0;
  for (int k = 0; k < 1000; ++k) {
    heat.sample(torque, 1, frame);
    EXPECT_GE(frame.overheating[0], before);
    before = frame.overheating[0];
  }
  EXPECT_EQ(before, 3);
}

TEST(Battery, GivesTheIntegralOfItsCurrent) {
  const BatteryModel model{2.0};
  Battery battery(model);
  SensorFrame frame;
  frame.current = JointArray<double>(2, 0.5);
  double drawn = 0;  // [A s]
  for (int k = 0; k < 1000; ++k) {
    frame.current[0] = 0.001 * k;
    battery.sample(1, frame);
    drawn -= frame.battery.current;
    EXPECT_LT(frame.battery.current, -0.5);
  }
  EXPECT_NEAR(frame.battery.charge, 1 - drawn / 7200, 1e-12);
  const double voltage = frame.battery.voltage;
  frame.current[0] += 1;
  battery.sample(0, frame);
  EXPECT_LT(frame.battery.voltage, voltage);  // a loaded battery gives less
}

TEST(Battery, ANaoDrawsMoreWhenItStandsThanLimp) {
  World world = oneNao(worldWith({}));
  const SensorFrame standing_frame = senseAfter(1, world);
  World limp = oneNao(worldWith({}));
  JointCommand off = standing(*limp.robot(0).model);
  off.stiffness = JointArray<double>(off.angle.size(), 0.0);
  EXPECT_LT(standing_frame.battery.current, senseAfter(1, limp, off).battery.current);
}

// A cone of 60 degrees at the origin, along x.
double inCone(const Shape& shape) {
  return calcDistanceInCone(Pose::Identity(), M_PI / 6, 2.55, shape, shape.X_BS).value_or(-1);
}

TEST(SonarCone, MeasuresToACentimetreInside) {
  for (const double distance : {0.3, 0.5, 1.0, 2.0, 2.5}) {
    // A wall ahead; a box's corner at 20 degrees; a ball at 25 degrees.
    EXPECT_NEAR(inCone(box({0.1, 4, 4}, {distance + 0.05, 0, 0})), distance, 0.01);
    const Vec3 aside(distance * std::cos(0.35), distance * std::sin(0.35), 0);
    EXPECT_NEAR(inCone(box({0.1, 0.1, 0.1}, aside + Vec3(0.05, 0.05, 0))), distance, 0.01);
    Shape ball;
    ball.size.x() = 0.05;
    const double centre = distance + 0.05;
    if (centre > 2.5) continue;
    ball.X_BS = translation({centre * std::cos(0.44), 0, centre * std::sin(0.44)});
    EXPECT_NEAR(inCone(ball), distance, 0.01);
  }
}

TEST(SonarCone, HearsWhatReachesIntoItFromOutside) {
  // A wall along the axis at y = 0.3: its nearest point inside the cone is on the rim.
  EXPECT_NEAR(inCone(box({10, 0.1, 4}, {0, 0.35, 0})), 0.3 / std::sin(M_PI / 6), 0.01);
}

TEST(SonarCone, IsDeafOutside) {
  EXPECT_EQ(inCone(box({0.1, 0.1, 0.1}, {1.0, 0.8, 0})), -1);
  EXPECT_EQ(inCone(box({0.1, 0.1, 0.1}, {-1.0, 0, 0})), -1);
  EXPECT_EQ(inCone(box({0.1, 4, 4}, {2.7, 0, 0})), -1);
}

TEST(Sonar, HearsTwoThingsAsTwoEchoesNearestFirst) {
  World world = oneNao(
      worldWith({box({0.1, 0.3, 1}, {1.05, 0.1, 0.4}), box({0.1, 0.3, 1}, {1.55, 0.1, 1.0})}));
  const SensorFrame frame = senseAfter(1, world);
  EXPECT_GT(frame.sonar[0][0], 0.8);
  EXPECT_LT(frame.sonar[0][0], 1.1);
  EXPECT_GT(frame.sonar[0][1], frame.sonar[0][0] + 0.3);
  EXPECT_EQ(frame.sonar[0][2], 2.55);  // no third
}

// Facing a wall square on. The receivers look 22.5 degrees outwards: the wall's nearest point is
// still inside their cones.
TEST(Sonar, ReadsTheDistanceOfAWall) {
  for (const double distance : {0.5, 1.0, 1.8}) {
    World world = oneNao(worldWith({box({0.1, 6, 2}, {distance + 0.05, 0, 1})}));
    const SensorFrame frame = senseAfter(1, world);
    const auto X_WB = world.scene().robots[0].X_WB[0];
    const Vec3 receiver = X_WB * Vec3(0.00558253, 0.0192068, 0.0623853);
    for (const SonarEchoes& echoes : frame.sonar) {
      EXPECT_NEAR(echoes[0], distance - receiver.x(), 0.01);
    }
  }
}

TEST(Sonar, ToldOfNothingTooNearButThatItIsThere) {
  World world = oneNao(worldWith({box({0.1, 6, 2}, {0.2, 0, 1.2})}));
  EXPECT_EQ(senseAfter(0.2, world).sonar[0][0], 0.25);
}

TEST(Sonar, HearsAnotherRobot) {
  auto model = std::make_shared<WorldModel>();
  const auto robot = test::robot("nao_h21_v33_ideal");
  World world(model, {{"a", robot, {}}, {"b", robot, {1.0, 0, M_PI}}}, 2ms);
  const SensorFrame frame = senseAfter(0.3, world);
  EXPECT_GT(frame.sonar[0][0], 0.8);
  EXPECT_LT(frame.sonar[0][0], 1.0);
}

TEST(Sonar, AnswersTenTimesASecond) {
  auto model = std::make_shared<WorldModel>();
  model->balls.push_back({});
  World world = oneNao(model);
  world.placeBall(0, Vec3(0.8, 0, 0.5), Vec3::Zero());
  const JointCommand command = standing(*world.robot(0).model);
  world.placeRobot(0, {}, &command.angle);
  int changes = 0;
  double before = 0;
  for (int cycle = 0; cycle < 100; ++cycle) {
    world.setCommand(0, command);
    world.placeBall(0, Vec3(0.5 + 0.005 * cycle, 0.1, 0.4), Vec3::Zero());
    for (int k = 0; k < 5; ++k) world.step();
    const double heard = world.readSensors(0).sonar[0][0];
    changes += heard != before ? 1 : 0;
    before = heard;
  }
  EXPECT_EQ(changes, 10);
}

TEST(Touch, FeelsPressesWhileTheyLast) {
  World world = oneNao(worldWith({}), "nao_h25_v50");
  senseAfter(0.1, world);
  world.press(0, "Head/Touch/Middle", 100ms);
  world.press(0, "RFoot/Bumper/Left", 100ms);
  world.press(0, "LHand/Touch/Back", 100ms);
  world.press(0, "ChestBoard/Button", 200ms);
  SensorFrame frame = world.readSensors(0);
  EXPECT_TRUE(frame.touch.head[1] && !frame.touch.head[0] && !frame.touch.head[2]);
  EXPECT_TRUE(frame.feet[1].bumper[0] && !frame.feet[1].bumper[1] && !frame.feet[0].bumper[0]);
  EXPECT_TRUE(frame.touch.hand[0][1] && !frame.touch.hand[1][1]);
  EXPECT_TRUE(frame.touch.chest_button);
  for (int k = 0; k < 75; ++k) world.step();
  frame = world.readSensors(0);
  EXPECT_FALSE(frame.touch.head[1] || frame.feet[1].bumper[0]);
  EXPECT_TRUE(frame.touch.chest_button);
}

TEST(Touch, NamesWhatItHasWhenAskedForMore) {
  World world = oneNao(worldWith({}));
  try {
    world.press(0, "Tail", 1ms);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Head/Touch/Front"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("Tail"), std::string::npos);
    EXPECT_EQ(std::string(error.what()).find("LHand"), std::string::npos);  // an H21 has none
  }
}

// Rocked to and fro it does not; a ball that rolls against the left toe does it, on that side.
TEST(Touch, BumpersFeelABallAndNotTheFloor) {
  auto model = worldWith({});
  model->balls.push_back({});
  World world = oneNao(model);
  const JointCommand command = standing(*world.robot(0).model);
  world.placeRobot(0, {}, &command.angle);
  world.placeBall(0, Vec3(5, 0, 0), Vec3::Zero());
  bool left = false;
  for (int cycle = 0; cycle < 200; ++cycle) {
    if (cycle == 20) world.push(0, Vec3(6, 0, 0), 300ms);
    if (cycle == 100) {
      EXPECT_FALSE(left);
      world.placeBall(0, Vec3(0.2, 0.069, 0), Vec3(-1, 0, 0));
    }
    world.setCommand(0, command);
    for (int k = 0; k < 5; ++k) {
      world.step();
      const SensorFrame frame = world.readSensors(0);
      left |= frame.feet[0].bumper[0] || frame.feet[0].bumper[1];
      EXPECT_FALSE(frame.feet[1].bumper[0] || frame.feet[1].bumper[1]);
    }
  }
  EXPECT_TRUE(left);
}

TEST(Sensors, GoOnFromASnapshotBitByBit) {
  World world = oneNao(worldWith({box({0.1, 6, 2}, {1, 0, 1})}), "nao_h21_v33");
  senseAfter(0.35, world);
  const auto snapshot = world.snapshot();
  const auto goOn = [&] {
    std::vector<double> seen;
    for (int cycle = 0; cycle < 30; ++cycle) {
      world.setCommand(0, standing(*world.robot(0).model));
      for (int k = 0; k < 5; ++k) world.step();
      const SensorFrame f = world.readSensors(0);
      seen.insert(seen.end(), {f.battery.charge, f.temperature[8], f.sonar[0][0], f.angle_y});
    }
    return seen;
  };
  const auto first = goOn();
  world.restore(*snapshot);
  EXPECT_EQ(first, goOn());
}

}  // namespace
}  // namespace nao::sim
