#include "walk_engine/zmp_gait.h"

#include <gtest/gtest.h>

#include <cmath>

#include "motion/kinematics.h"
#include "tests/motion/biped.h"
#include "tests/support/models.h"

namespace nao::walk {
namespace {

using motion::GaitConfig;

// The gait alone, without physics: what it commands.
class ZmpGaitTest : public testing::TestWithParam<const char*> {
 protected:
  void standIn(const std::string& posture) { command_.angle = model_->findPosture(posture)->angle; }
  void cycle() {
    measured_.time += model_->cycle;
    gait_->update(measured_, command_);
  }
  void run(double seconds) {
    for (double t = 0; t < seconds; t += toSeconds(model_->cycle)) cycle();
  }
  double runToEnd() {
    double t = 0;
    for (; gait_->active() && t < 60; t += toSeconds(model_->cycle)) cycle();
    return t;
  }

  std::shared_ptr<const RobotModel> model_ = test::robot(GetParam());
  std::unique_ptr<motion::Gait> gait_ = makeZmpGait(model_);
  JointCommand command_{model_->findPosture("StandInit")->angle,
                        JointArray<double>(model_->jointCount(), 1)};
  SensorFrame measured_;
};

TEST_P(ZmpGaitTest, LeavesTheCommandAloneBeforeTheFirstRequest) {
  const JointCommand before = command_;
  run(0.1);
  EXPECT_FALSE(gait_->active());
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    EXPECT_EQ(command_.angle[i], before.angle[i]);
  }
}

TEST_P(ZmpGaitTest, EndsAtTheTargetByOdometryAtRest) {
  gait_->walkTo({0.3, 0.2, 0.5}, GaitConfig());
  EXPECT_LT(runToEnd(), 20);
  EXPECT_FALSE(gait_->active());
  EXPECT_NEAR(gait_->position().x, 0.3, 1e-6);
  EXPECT_NEAR(gait_->position().y, 0.2, 1e-6);
  EXPECT_NEAR(gait_->position().theta, 0.5, 1e-6);
  EXPECT_EQ(gait_->velocity().x, 0);
}

// A foot that the force sensors feel before the plan has it land answers a fall like one that
// stands.
TEST_P(ZmpGaitTest, AFootThatLandsEarlyHelpsToBalance) {
  gait_->walkToward(1, 0, 0, GaitConfig());
  run(3);
  measured_.gyroscope = {0.5, 0, 0};
  std::array<int, 2> ankles_that_answer{};  // unfelt, felt
  for (int i = 0; i < 42; ++i) {
    JointCommand unfelt = command_, felt = command_;
    measured_.time += model_->cycle;
    measured_.feet[0].total = measured_.feet[1].total = 0;
    gait_->clone()->update(measured_, unfelt);
    measured_.feet[0].total = measured_.feet[1].total = 10;
    gait_->clone()->update(measured_, felt);
    gait_->update(measured_, command_);
    for (const char* ankle : {"LAnkleRoll", "RAnkleRoll"}) {
      const Joint joint = *model_->findJoint(ankle);
      ankles_that_answer[1] += felt.angle[joint] > unfelt.angle[joint] + 0.02;
      ankles_that_answer[0] += felt.angle[joint] < unfelt.angle[joint] - 0.02;
    }
  }
  EXPECT_EQ(ankles_that_answer[0], 0);
  EXPECT_GT(ankles_that_answer[1], 20);  // one foot swings for two thirds of the time
}

TEST_P(ZmpGaitTest, AddsUpOdometryFromWalkToWalk) {
  for (int i = 0; i < 4; ++i) {
    gait_->walkTo({0.1, 0, M_PI / 2}, GaitConfig());
    runToEnd();
  }
  EXPECT_NEAR(std::hypot(gait_->position().x, gait_->position().y), 0, 1e-5);
  EXPECT_NEAR(wrapAngle(gait_->position().theta), 0, 1e-5);
}

TEST_P(ZmpGaitTest, NeverAsksAJointForMoreThanItsTopSpeedOrRange) {
  for (const char* posture : {"StandInit", "Crouch", "Stand", "StandZero"}) {
    standIn(posture);
    gait_->walkToward(1, 0.3, 0.5, GaitConfig());
    JointArray<double> last = command_.angle;
    for (int i = 0; i < 1500; ++i) {
      if (i == 600) gait_->walkToward(-1, -1, -1, GaitConfig());
      if (i == 1000) gait_->stop();
      cycle();
      for (std::size_t k = 0; k < model_->jointCount(); ++k) {
        const Actuator& motor = model_->actuators[k];
        const double speed = std::abs(command_.angle[k] - last[k]) / toSeconds(model_->cycle);
        if (motor.max_velocity > 0) {
          ASSERT_LE(speed, motor.max_velocity * (1 + 1e-9))
              << posture << ' ' << motor.name << " cycle " << i;
        }
        ASSERT_LE(command_.angle[k], motor.upper + 1e-9) << motor.name;
        ASSERT_GE(command_.angle[k], motor.lower - 1e-9) << motor.name;
      }
      last = command_.angle;
    }
    ASSERT_FALSE(gait_->active());
  }
}

TEST_P(ZmpGaitTest, StopsFeetSideBySideSoonAfterStop) {
  gait_->walkToward(1, 0, 0, GaitConfig());
  run(3);
  gait_->stop();
  EXPECT_LT(runToEnd(), 0.42 + 0.42 + 0.6 + 0.5);  // this step, one to close, standing, settling
  EXPECT_TRUE(gait_->footsteps().empty());
}

TEST_P(ZmpGaitTest, FreezesAtOnceWhenKilled) {
  gait_->walkToward(1, 0, 0, GaitConfig());
  run(2);
  gait_->kill();
  EXPECT_FALSE(gait_->active());
  const JointCommand before = command_;
  run(0.1);
  for (std::size_t i = 0; i < model_->jointCount(); ++i) {
    EXPECT_EQ(command_.angle[i], before.angle[i]);
  }
}

TEST_P(ZmpGaitTest, PlansFootstepsAheadAndSaysWhereItWillBe) {
  gait_->walkToward(1, 0, 0, GaitConfig());
  run(2);
  const auto steps = gait_->footsteps();
  ASSERT_GE(steps.size(), 3u);
  EXPECT_NE(steps[0].foot, steps[1].foot);
  EXPECT_GT(steps[1].lands, steps[0].lands);
  EXPECT_EQ(steps[1].lands - steps[0].lands, fromSeconds(0.42));
  EXPECT_GT(gait_->nextPosition().x, gait_->position().x);
  EXPECT_NEAR(gait_->velocity().x, 0.0952, 0.0005);  // [m/s] Aldebaran's top speed
}

TEST_P(ZmpGaitTest, SwingsTheArmsAgainstTheLegs) {
  const Joint left = *model_->findJoint("LShoulderPitch");
  const double rest = command_.angle[left];
  gait_->walkToward(1, 0, 0, GaitConfig());
  double lowest = 0;
  double highest = 0;
  for (int i = 0; i < 400; ++i) {
    cycle();
    lowest = std::min(lowest, command_.angle[left] - rest);
    highest = std::max(highest, command_.angle[left] - rest);
  }
  EXPECT_NEAR(highest, 0.1, 0.03);  // 2.5 rad/m at feet 0.04 m apart
  EXPECT_NEAR(lowest, -0.1, 0.03);
}

INSTANTIATE_TEST_SUITE_P(Robots, ZmpGaitTest, testing::Values("nao_h21_v33", "nao_h25_v50"));

TEST(ZmpGait, IsNullForLegsOfAnotherKind) {
  const auto biped = test::makeBiped();
  EXPECT_NE(makeZmpGait(biped), nullptr);
  biped->bodies[2].axis = Vec3::UnitY();
  EXPECT_EQ(makeZmpGait(biped), nullptr);
}

}  // namespace
}  // namespace nao::walk
