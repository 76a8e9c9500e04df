#include "walk_engine/step_rules.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace nao::walk {
namespace {

using motion::GaitConfig;

constexpr double kRounding = 1e-12;

TEST(StepRules, WalkForwardAtThePublishedSpeed) {
  const GaitConfig config;
  const double speed = calcPairReach({1, 0, 0}, config).x / (2 * calcStepPeriod(config));
  EXPECT_NEAR(speed, 0.0952, 0.00005);  // [m/s] published with two digits after the comma of cm
}

TEST(StepRules, SideStepAtThePublishedSpeed) {
  const GaitConfig config;
  const double speed = calcPairReach({0, 1, 0}, config).y / (2 * calcStepPeriod(config));
  EXPECT_NEAR(speed, (0.14 - 0.088) / 0.84, kRounding);  // [m/s]
}

TEST(StepRules, TurnAtTheRateTheRobotWasSeenToTurn) {
  const GaitConfig config;
  const double rate = calcPairReach({0, 0, 1}, config).theta / (2 * calcStepPeriod(config));
  EXPECT_NEAR(rate * 180 / M_PI, 42, 0.05);  // [degrees/s] reported without a decimal
}

TEST(StepRules, StepSlowerAtLowerFrequency) {
  GaitConfig config;
  EXPECT_NEAR(calcStepPeriod(config), 0.42, kRounding);
  config.max_step_frequency = 0;
  EXPECT_NEAR(calcStepPeriod(config), 0.6, kRounding);
}

TEST(StepRules, KeepTheFeetApartAndOffEachOtherWhateverIsAsked) {
  const GaitConfig config;
  Random random(3);
  for (int i = 0; i < 2000; ++i) {
    const Foot foot = i % 2 == 0 ? Foot::Left : Foot::Right;
    const Pose2 wish{random.uniform(-0.2, 0.2), random.uniform(-0.3, 0.3), random.uniform(-1, 1)};
    const Pose2 step = clipStep(wish, foot, config);
    ASSERT_GE(sideOf(foot) * step.y, kMinFootSeparation - kRounding);
    ASSERT_LE(sideOf(foot) * step.y, config.max_step_y + kRounding);
    ASSERT_LE(std::abs(step.x), config.max_step_x + kRounding);
    ASSERT_LE(std::abs(step.theta), config.max_step_theta + kRounding);
    ASSERT_FALSE(feetCollide(step, foot));
  }
}

TEST(StepRules, LeaveAStepAloneThatIsAllowed) {
  const GaitConfig config;
  const Pose2 step = clipStep({0.02, 0.11, 0.1}, Foot::Left, config);
  EXPECT_DOUBLE_EQ(step.x, 0.02);
  EXPECT_DOUBLE_EQ(step.y, 0.11);
  EXPECT_DOUBLE_EQ(step.theta, 0.1);
}

TEST(StepRules, TurnToesOutFullyAndToesInOnlyUntilTheBoxesMeet) {
  const GaitConfig config;
  EXPECT_DOUBLE_EQ(calcStep({0, 0, 1}, Foot::Left, config).theta, config.max_step_theta);
  const double toe_in = -calcStep({0, 0, -1}, Foot::Left, config).theta;
  EXPECT_LT(toe_in, config.max_step_theta);
  EXPECT_TRUE(feetCollide({0, kFootSeparation, -toe_in - 1e-6}, Foot::Left));
}

TEST(StepRules, ClipLongAndWideStepsToTheEllipse) {
  const GaitConfig config;
  const Pose2 step = clipStep({0.04, 0.14, 0}, Foot::Left, config);
  const double along = step.x / config.max_step_x;
  const double across = (step.y - kFootSeparation) / (config.max_step_y - kFootSeparation);
  EXPECT_NEAR(std::hypot(along, across), 1, kRounding);
}

TEST(StepRules, AreMirrorImagesForTheOtherFoot) {
  const GaitConfig config;
  const Pose2 left = calcStep({0.5, 0.7, -0.9}, Foot::Left, config);
  const Pose2 right = calcStep({0.5, -0.7, 0.9}, Foot::Right, config);
  EXPECT_NEAR(left.x, right.x, kRounding);
  EXPECT_NEAR(left.y, -right.y, kRounding);
  EXPECT_NEAR(left.theta, -right.theta, 1e-9);  // found by bisection
}

TEST(StepRules, TurnAVelocityIntoStepsOfThatVelocity) {
  const GaitConfig config;
  const StepFractions fractions = fractionsFor({0.05, 0, 0}, config);
  const double pair = calcStep(fractions, Foot::Left, config).x * 2;
  EXPECT_NEAR(pair / (2 * calcStepPeriod(config)), 0.05, kRounding);
}

// ALMotion.move asks for a velocity: what the steps can give they give, whatever of a full step
// would be clipped.
TEST(FractionsFor, GiveTheVelocityAskedFor) {
  const GaitConfig config;
  const double pair = 2 * calcStepPeriod(config);
  for (const motion::Velocity2& asked :
       {motion::Velocity2{0.05, 0, 0}, motion::Velocity2{-0.09, 0, 0},
        motion::Velocity2{0, 0.03, 0}, motion::Velocity2{0, -0.06, 0},
        motion::Velocity2{0, 0, 0.133}, motion::Velocity2{0, 0, -0.7}}) {
    const StepFractions fractions = fractionsFor(asked, config);
    const Pose2 left = calcStep(fractions, Foot::Left, config);
    const Pose2 right = calcStep(fractions, Foot::Right, config);
    EXPECT_NEAR((left.x + right.x) / pair, asked.x, 1e-6);
    EXPECT_NEAR((left.y + right.y) / pair, asked.y, 1e-6);
    EXPECT_NEAR((left.theta + right.theta) / pair, asked.theta, 1e-6);
  }
}

TEST(StepRoom, ReachesAsFarAsTheLargestStepsAndNoNearerThanFeetMayCome) {
  const StepRoom left = calcStepRoom({0.04, 0.1, 0}, Foot::Left);
  EXPECT_NEAR(left.low.x(), -0.12, 1e-12);
  EXPECT_NEAR(left.high.x(), 0.04, 1e-12);
  EXPECT_NEAR(left.low.y(), -0.012, 1e-12);
  EXPECT_NEAR(left.high.y(), 0.06, 1e-12);
  const StepRoom right = calcStepRoom({0, -0.1, 0}, Foot::Right);
  EXPECT_NEAR(right.low.y(), -0.06, 1e-12);
  EXPECT_NEAR(right.high.y(), 0.012, 1e-12);
  EXPECT_EQ(calcStepRoom({0, 0.1, 0.3}, Foot::Left).low.y(), 0);
}

}  // namespace
}  // namespace nao::walk
