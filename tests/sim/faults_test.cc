#include "sim/faults.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/check.h"
#include "sim/world.h"
#include "tests/support/models.h"

namespace nao::sim {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

/// A Nao that stands, told so every 10 ms.
class FaultyNao : public testing::Test {
 protected:
  FaultyNao() {
    command_ = {model_->findPosture("StandInit")->angle,
                JointArray<double>(model_->jointCount(), 1.0)};
    world_.placeRobot(0, {}, &command_.angle);
  }
  void hold(Duration duration) {
    for (const SimTime end = world_.now() + duration; world_.now() < end;) {
      frame_ = world_.readSensors(0);
      world_.setCommand(0, command_);
      for (int i = 0; i < 5; ++i) world_.step();
    }
  }
  Joint joint(const char* name) const { return *model_->findJoint(name); }

  const std::shared_ptr<const RobotModel> model_ = test::robot("nao_h21_v33_ideal");
  World world_{test::flatWorld(), {{"nao", model_, {}}}, 2ms};
  JointCommand command_;
  SensorFrame frame_;
};

TEST_F(FaultyNao, ADeadMotorGivesWayUntilItLivesAgain) {
  const Joint shoulder = joint("LShoulderPitch");
  command_.angle[shoulder] = 0.5;  // held out before the body: its weight pulls it down
  hold(1s);
  EXPECT_NEAR(frame_.angle[shoulder], 0.5, 0.05);
  world_.killJoint(0, shoulder, 1500ms);
  hold(1500ms);
  EXPECT_GT(frame_.angle[shoulder], 0.8);
  EXPECT_NEAR(frame_.angle[joint("RShoulderPitch")], command_.angle[joint("RShoulderPitch")], 0.05);
  hold(1500ms);
  EXPECT_NEAR(frame_.angle[shoulder], 0.5, 0.05);
}

TEST_F(FaultyNao, AFrozenEncoderStandsStillWhileTheJointMoves) {
  const Joint head = joint("HeadYaw");
  hold(500ms);
  world_.freezeSensor(0, "HeadYaw", 1s);
  command_.angle[head] = 0.5;
  hold(20ms);
  const double held = frame_.angle[head];
  hold(900ms);
  EXPECT_EQ(frame_.angle[head], held);
  hold(200ms);
  EXPECT_NEAR(frame_.angle[head], 0.5, 0.05);
}

TEST_F(FaultyNao, NoiseHasTheDeviationAskedForAndIsOnItsSensorAlone) {
  hold(1s);
  world_.disturbSensor(0, "Accelerometer", 2.0, 20s);
  double sum = 0, squares = 0;
  constexpr int kFrames = 1000;
  for (int i = 0; i < kFrames; ++i) {
    hold(10ms);
    sum += frame_.accelerometer.x();
    squares += frame_.accelerometer.x() * frame_.accelerometer.x();
    EXPECT_LT(std::abs(frame_.gyroscope.x()), 0.05);
  }
  const double mean = sum / kFrames;
  const double sd = std::sqrt(squares / kFrames - mean * mean);
  EXPECT_NEAR(sd, 2.0, 0.2);  // 4.5 SD of the estimate of 1,000 normal numbers
}

TEST_F(FaultyNao, AFrozenGyroscopeDeceivesTheTorsosAngle) {
  hold(500ms);
  world_.disturbSensor(0, "Gyroscope", 3.0, 3s);
  double most = 0;
  for (int i = 0; i < 200; ++i) {
    hold(10ms);
    most = std::max(most, std::abs(frame_.angle_y - frame_.angle_x));
  }
  EXPECT_GT(most, 0.02);  // rad; it stands still: without the fault it is below 0.01
}

TEST_F(FaultyNao, FootForcesThatAreNoisySayTheirOwnSum) {
  hold(500ms);
  world_.disturbSensor(0, "LFoot/FSR", 1.0, 1s);
  hold(50ms);
  double sum = 0;
  for (const double force : frame_.feet[0].force) sum += force;
  EXPECT_NEAR(frame_.feet[0].total, sum, 1e-12);
  for (const double force : frame_.feet[0].force) EXPECT_GE(force, 0);
}

TEST_F(FaultyNao, MotorsAndBatteryAreAsTheyAreSetAndGoOnFromThere) {
  hold(100ms);
  world_.heatMotor(0, joint("LKneePitch"), 90);
  world_.setCharge(0, 0.1);
  hold(20ms);
  EXPECT_NEAR(frame_.temperature[joint("LKneePitch")], 90, 0.1);
  EXPECT_EQ(frame_.overheating[joint("LKneePitch")], 2);
  EXPECT_NEAR(frame_.battery.charge, 0.1, 1e-4);
  hold(10s);
  EXPECT_LT(frame_.temperature[joint("LKneePitch")], 89.5);  // it cools
  EXPECT_LT(frame_.battery.charge, 0.1);
}

TEST_F(FaultyNao, WhatBreaksIsPartOfASnapshot) {
  hold(200ms);
  world_.disturbSensor(0, "HeadYaw", 0.1, 5s);
  world_.freezeSensor(0, "HeadPitch", 5s);
  world_.killJoint(0, joint("LElbowRoll"), 5s);
  world_.dirtyLens(0, 0, 0.5);
  world_.wetFloor({0, 0}, 0.3, 0.1, 300ms);
  hold(100ms);
  const auto snapshot = world_.snapshot();
  hold(1s);
  const auto hash = world_.hash();
  const double noisy = frame_.angle[joint("HeadYaw")];
  world_.restore(*snapshot);
  hold(1s);
  EXPECT_EQ(world_.hash(), hash);
  EXPECT_EQ(frame_.angle[joint("HeadYaw")], noisy);
  EXPECT_EQ(world_.scene().robots[0].lens_dirt.at(0), 0.5F);
}

TEST_F(FaultyNao, AResetMendsEverything) {
  world_.killJoint(0, joint("LKneePitch"), std::chrono::hours(1));
  world_.freezeSensor(0, "HeadYaw", std::chrono::hours(1));
  world_.dirtyLens(0, 0, 1);
  world_.wetFloor({0, 0}, 1, 0, std::chrono::hours(1));
  hold(1s);
  world_.reset();
  World fresh(test::flatWorld(), {{"nao", model_, {}}}, 2ms);
  EXPECT_EQ(world_.scene().robots[0].lens_dirt.at(0), 0);
  for (int i = 0; i < 100; ++i) {
    world_.step();
    fresh.step();
  }
  EXPECT_EQ(world_.readSensors(0).angle[0], fresh.readSensors(0).angle[0]);
  EXPECT_EQ((world_.scene().robots[0].X_WB[0].translation() -
             fresh.scene().robots[0].X_WB[0].translation())
                .norm(),
            0);
}

TEST_F(FaultyNao, ASensorThatIsNotThereIsRefusedWithThoseThatAre) {
  try {
    world_.freezeSensor(0, "Nose", 1s);
    FAIL();
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("HeadYaw"), std::string::npos) << text;
    EXPECT_NE(text.find("found 'Nose'"), std::string::npos) << text;
  }
}

// A block that slides over a wet patch: Coulomb's law in each part.
TEST(WetFloor, HoldsLessInsideItsCircleOnly) {
  const auto model = test::block(1, {0.1, 0.1, 0.1});
  const auto slowDown = [&](double wet_x) {
    World world(test::flatWorld(), {{"block", model, {}}}, 2ms);
    world.wetFloor({wet_x, 0}, 0.5, 0.1, 10s);
    for (int i = 0; i < 100; ++i) world.step();  // it rests
    world.push(0, {20, 0, 0}, 100ms);
    for (int i = 0; i < 50; ++i) world.step();
    const double before = world.scene().robots[0].X_WB[0].translation().x();
    for (int i = 0; i < 50; ++i) world.step();
    return world.scene().robots[0].X_WB[0].translation().x() - before;
  };
  const double dry = slowDown(50);
  const double wet = slowDown(0);
  // After 100 ms of (20 - mu g) m/s^2 it slides on with what it has: v t - mu g t^2 / 2.
  const auto law = [](double mu) {
    const double t = 0.1;
    const double v = (20 - mu * 9.80665) * t;
    return v * t - mu * 9.80665 * t * t / 2;
  };
  EXPECT_NEAR(wet, law(0.1), 0.02 * law(0.1));
  EXPECT_NEAR(dry, law(test::flatWorld()->ground.friction), 0.03 * law(0.7));
  EXPECT_GT(wet, dry * 1.2);
}

}  // namespace
}  // namespace nao::sim
