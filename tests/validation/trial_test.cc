// One robot as the experiments drive it.
#include "validation/trial.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

ExperimentSettings settings() {
  ExperimentSettings settings;
  settings.robots_dir = NAO_SOURCE_DIR "/robots";
  return settings;
}

TEST(Trial, SeesTheRobotStandUpAndNotFall) {
  Trial trial(settings(), 1);
  EXPECT_LT(trial.bodies()[0].translation().z(), 0.3);
  trial.standUp();
  EXPECT_FALSE(trial.fell());
  EXPECT_GT(trial.bodies()[0].translation().z(), 0.3);
  EXPECT_EQ(trial.here().truth.x, 0);  // places count from here
}

TEST(Trial, SeesAFall) {
  Trial trial(settings(), 1);
  trial.standUp();
  trial.simulation().world().push(0, {60, 0, 0}, 500ms);  // more than its weight of 48 N
  trial.wait(2s);
  EXPECT_TRUE(trial.fell());
}

TEST(Trial, CountsEveryLandingOnce) {
  Trial trial(settings(), 0);
  trial.standUp();
  trial.ask(motion::MoveTo{{0.12, 0, 0}, {}, {}});  // 0.04 m a step, then the other foot beside
  EXPECT_FALSE(trial.waitForLandings(99, 8s));
  EXPECT_EQ(trial.landings(), 4);
  EXPECT_NEAR(trial.here().odometry.x, 0.12, 1e-9);
}

TEST(Trial, CountsTurnsBeyondHalfATurn) {
  Trial trial(settings(), 0);
  trial.standUp();
  trial.ask(motion::MoveToward{0, 0, 1, {}});
  trial.wait(7s);
  EXPECT_GT(trial.here().truth.theta, M_PI);
  EXPECT_GT(trial.here().odometry.theta, M_PI);
}

TEST(Trial, GoesOnFromASnapshotToTheLastBit) {
  Trial trial(settings(), 3);
  trial.standUp();
  trial.ask(motion::MoveToward{1, 0, 0, {}});
  trial.wait(2s);
  const auto snapshot = trial.snapshot();
  trial.wait(1s);
  const std::uint64_t hash = trial.simulation().hash();
  const TrialPoint there = trial.here();
  trial.simulation().world().push(0, {20, 0, 0}, 300ms);
  trial.wait(2s);
  trial.restore(*snapshot);
  trial.wait(1s);
  EXPECT_EQ(trial.simulation().hash(), hash);
  EXPECT_EQ(trial.here().truth.x, there.truth.x);
}

TEST(Trial, ConditionsChangeTheBodyAndTheGroundButNotWhatMotionKnows) {
  Conditions conditions;
  conditions.slope = 0.05;
  conditions.friction = 0.9;
  conditions.mass_difference = 0.05;
  const auto nominal = loadRobot(settings());
  Trial trial(settings(), 1, conditions);
  EXPECT_DOUBLE_EQ(trial.model().totalMass(), nominal->totalMass());
  EXPECT_EQ(trial.simulation().world().model().ground.friction, 0.9);
  EXPECT_EQ(trial.simulation().world().draw().count("nao.floor_friction.friction"), 0u);
  trial.standUp();
  EXPECT_FALSE(trial.fell());
  double weight = 0;
  for (const auto& force : trial.simulation().world().contacts().forces) {
    weight += force.f_W.z();
  }
  EXPECT_NEAR(weight, 1.05 * nominal->totalMass() * 9.80665, 0.5);  // [N] it still sways
}

}  // namespace
}  // namespace nao::validation
