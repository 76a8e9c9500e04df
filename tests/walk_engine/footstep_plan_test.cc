#include "walk_engine/footstep_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"

namespace nao::walk {
namespace {

constexpr double kTick = 0.01;        // [s]
constexpr std::int64_t kAhead = 120;  // [ticks]
constexpr double kSame = 1e-6;        // [m], [rad] the plan's own idea of the same place

FeetPlaces sideBySide() { return {Pose2{0, 0.05, 0}, Pose2{0, -0.05, 0}}; }

Goal toTarget(const Pose2& target) {
  Goal goal;
  goal.kind = Goal::Kind::Target;
  goal.target = target;
  return goal;
}

Goal atFractions(double x, double y, double theta) {
  Goal goal;
  goal.kind = Goal::Kind::Velocity;
  goal.fractions = {x, y, theta};
  return goal;
}

class FootstepPlanTest : public testing::Test {
 protected:
  FootstepPlanTest() { plan_.reset(sideBySide(), 0); }

  void runUntilRest(std::int64_t limit) {
    while (!plan_.atRest(tick_) && tick_ < limit) runFor(1);
  }
  void runFor(std::int64_t ticks) {
    for (const std::int64_t end = tick_ + ticks; tick_ < end;) {
      ++tick_;
      plan_.advance(tick_, tick_ + kAhead);
    }
  }

  FootstepPlan plan_{Tuning{}, kTick};
  std::int64_t tick_ = 0;
};

TEST_F(FootstepPlanTest, StandsStillWithoutAGoal) {
  EXPECT_TRUE(plan_.atRest(0));
  EXPECT_EQ(plan_.current(), nullptr);
}

TEST_F(FootstepPlanTest, EndsExactlyAtAnyTargetWithTheFeetSideBySide) {
  Random random(11);
  for (int i = 0; i < 100; ++i) {
    const Pose2 target{random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8),
                       random.uniform(-M_PI, M_PI)};
    plan_.reset(sideBySide(), tick_);
    plan_.follow(toTarget(target), tick_);
    runUntilRest(tick_ + 6000);
    ASSERT_TRUE(plan_.atRest(tick_));
    for (const Foot foot : {Foot::Left, Foot::Right}) {
      const Pose2 off = relativeTo(soleAt(target, foot), plan_.feet()[index(foot)]);
      ASSERT_NEAR(std::hypot(off.x, off.y), 0, kSame);
      ASSERT_NEAR(off.theta, 0, kSame);
    }
  }
}

TEST_F(FootstepPlanTest, TakesAsManyStepsAsTheDistanceNeedsAndOneToClose) {
  plan_.follow(toTarget({0.4, 0, 0}), tick_);
  int steps = 0;
  const PlannedStep* last = nullptr;
  std::int64_t start = -1;
  while (!plan_.atRest(tick_)) {
    runFor(1);
    last = plan_.current();
    if (last != nullptr && last->start != start) {
      start = last->start;
      ++steps;
    }
  }
  EXPECT_EQ(steps, 11);  // ten of 0.04 m, and one that closes
}

TEST_F(FootstepPlanTest, AlternatesTheFeetBeginningOnTheSideItGoesTo) {
  plan_.follow(atFractions(0, -1, 0), tick_);
  plan_.advance(tick_, kAhead);
  ASSERT_GE(plan_.steps().size(), 2u);
  EXPECT_EQ(plan_.steps()[0].swing, Foot::Right);
  EXPECT_EQ(plan_.steps()[1].swing, Foot::Left);
}

TEST_F(FootstepPlanTest, NeverChangesTheStepUnderWay) {
  plan_.follow(atFractions(1, 0, 0), tick_);
  runFor(150);
  ASSERT_NE(plan_.current(), nullptr);
  const PlannedStep before = *plan_.current();
  plan_.follow(atFractions(-1, 0, 0.5), tick_);
  plan_.advance(tick_, tick_ + kAhead);
  EXPECT_EQ(plan_.current()->to.x, before.to.x);
  EXPECT_EQ(plan_.current()->end(), before.end());
  EXPECT_LT(plan_.steps()[1].to.x, before.to.x);  // but the next goes back
}

TEST_F(FootstepPlanTest, StopsWithinOneMoreStepFeetSideBySide) {
  plan_.follow(atFractions(1, 0.3, 0.4), tick_);
  runFor(300);
  const std::int64_t stopped = tick_;
  plan_.follow(Goal(), tick_);
  runUntilRest(tick_ + 1000);
  // At most the rest of this step, the closing one, and 0.6 s of standing.
  EXPECT_LE(tick_ - stopped, 42 + 42 + 60);
  const Pose2 apart = relativeTo(plan_.feet()[1], plan_.feet()[0]);
  EXPECT_NEAR(apart.x, 0, kSame);
  EXPECT_NEAR(apart.y, kFootSeparation, kSame);
  EXPECT_NEAR(apart.theta, 0, kSame);
}

TEST_F(FootstepPlanTest, RestsTheZmpInTheSupportingSoleWhileAFootSwings) {
  plan_.follow(atFractions(0.6, 0.5, 0.7), tick_);
  for (int i = 0; i < 600; ++i) {
    runFor(1);
    const PlannedStep* step = plan_.current();
    if (step == nullptr || tick_ <= step->lift()) continue;
    const Eigen::Vector2d zmp = plan_.calcZmp(tick_);
    const Pose2 support = plan_.feet()[index(otherFoot(step->swing))];
    const Pose2 in_sole = relativeTo(support, {zmp.x(), zmp.y(), 0});
    ASSERT_NEAR(in_sole.x, Tuning{}.zmp_x, kSame);
    ASSERT_NEAR(in_sole.y, 0, 0.01);
  }
}

TEST_F(FootstepPlanTest, GoesStraightAheadFromSplayedFeet) {
  plan_.reset({Pose2{0, 0.055, 0.15}, Pose2{0, -0.055, -0.15}}, tick_);
  plan_.follow(atFractions(1, 0, 0), tick_);
  runFor(500);
  EXPECT_NEAR(robotPlace(plan_.feet()).theta, 0, kSame);
  EXPECT_GT(robotPlace(plan_.feet()).x, 0.3);
}

TEST_F(FootstepPlanTest, MovesTheZmpWithoutJumps) {
  plan_.follow(atFractions(1, 0, 0.5), tick_);
  Eigen::Vector2d last = plan_.calcZmp(tick_);
  for (int i = 0; i < 800; ++i) {
    if (i == 400) plan_.follow(Goal(), tick_);
    runFor(1);
    const Eigen::Vector2d zmp = plan_.calcZmp(tick_);
    // Up to 0.16 m in the 0.14 s of a double support.
    ASSERT_LE((zmp - last).norm(), 0.16 / 14 + kSame);
    last = zmp;
  }
}

motion::StepOrder orderOf(Foot foot, double x, double y, double theta, double period = 0.6) {
  return {foot, {x, y, theta}, period};
}

TEST_F(FootstepPlanTest, OrderedStepsLandWhereTheyWereOrderedAndTheFeetStayThere) {
  plan_.order({orderOf(Foot::Left, 0.05, 0.11, 0.2), orderOf(Foot::Right, 0.02, -0.1, 0)}, true, 0);
  runUntilRest(2000);
  const Pose2 left = relativeTo(Pose2{0, -0.05, 0}, plan_.feet()[0]);
  const Pose2 right = relativeTo(plan_.feet()[0], plan_.feet()[1]);
  EXPECT_NEAR(left.x, 0.05, kSame);
  EXPECT_NEAR(left.y, 0.11, kSame);
  EXPECT_NEAR(left.theta, 0.2, kSame);
  EXPECT_NEAR(right.x, 0.02, kSame);
  EXPECT_NEAR(right.y, -0.1, kSame);
  EXPECT_NEAR(right.theta, 0, kSame);
}

TEST_F(FootstepPlanTest, OrderedStepsFollowEachOtherOrReplaceWhatMayStillChange) {
  for (const bool clear : {false, true}) {
    plan_.reset(sideBySide(), tick_);
    plan_.order({orderOf(Foot::Left, 0.04, 0.1, 0), orderOf(Foot::Right, 0.04, -0.1, 0),
                 orderOf(Foot::Left, 0.04, 0.1, 0)},
                true, tick_);
    runFor(80);
    ASSERT_EQ(plan_.current()->swing, Foot::Left);
    plan_.order({orderOf(Foot::Right, 0, -0.1, 0)}, clear, tick_);
    runUntilRest(tick_ + 2000);
    // Four steps, or the one under way and the last.
    EXPECT_NEAR(plan_.feet()[1].x, clear ? 0.04 : 0.12, kSame);
    EXPECT_NEAR(plan_.feet()[0].x, clear ? 0.04 : 0.12, kSame);
  }
}

TEST_F(FootstepPlanTest, OrderedStepsTakeTheirTimeButNoneIsFasterThanAnyStep) {
  plan_.order({orderOf(Foot::Left, 0.04, 0.1, 0), orderOf(Foot::Right, 0.04, -0.1, 0, 0.9),
               orderOf(Foot::Left, 0.04, 0.1, 0, 0.1)},
              true, 0);
  runFor(1);
  ASSERT_GE(plan_.steps().size(), 2u);
  EXPECT_EQ(plan_.steps()[1].end() - plan_.steps()[1].start, 90);
  runFor(120);
  ASSERT_GE(plan_.steps().size(), 2u);
  EXPECT_EQ(plan_.steps().back().end() - plan_.steps().back().start, 42);
}

TEST_F(FootstepPlanTest, AnOrderedStepOutOfReachIsClippedToTheWidestGait) {
  plan_.order({orderOf(Foot::Left, 0.3, 0.1, 0)}, true, 0);
  runUntilRest(2000);
  EXPECT_NEAR(plan_.feet()[0].x, 0.08, kSame);
}

// What a swaying robot does: every landing is moved by a centimetre, to and fro.
TEST_F(FootstepPlanTest, ComesToRestThoughEveryLandingGoesAstray) {
  for (const Goal& goal : {toTarget({0.2, 0, 0}), Goal()}) {
    plan_.reset({Pose2{0, 0.05, 0}, Pose2{0.04, -0.05, 0}}, tick_);
    plan_.follow(goal, tick_);
    std::int64_t start = -1;
    double side = 0.01;
    for (const std::int64_t end = tick_ + 1500; !plan_.atRest(tick_) && tick_ < end;) {
      runFor(1);
      const PlannedStep* step = plan_.current();
      if (step == nullptr || step->start == start || tick_ <= step->lift()) continue;
      start = step->start;
      plan_.moveLanding({side, 0});
      side = -side;
    }
    ASSERT_TRUE(plan_.atRest(tick_));
    if (goal.kind == Goal::Kind::Stand) continue;
    EXPECT_NEAR(robotPlace(plan_.feet()).x, 0.2, 0.01);  // each foot is a centimetre off at most
  }
}

TEST_F(FootstepPlanTest, MendsALastLandingThatWentAstrayOnce) {
  plan_.follow(toTarget({0.2, 0, 0}), tick_);
  bool moved = false;
  while (!plan_.atRest(tick_)) {
    runFor(1);
    const PlannedStep* step = plan_.current();
    if (moved || step == nullptr || !step->arrives || tick_ <= step->lift()) continue;
    plan_.moveLanding({0.02, 0.01});
    moved = true;
  }
  EXPECT_TRUE(moved);
  EXPECT_NEAR(robotPlace(plan_.feet()).x, 0.2, kSame);
  EXPECT_NEAR(robotPlace(plan_.feet()).y, 0, kSame);
}

}  // namespace
}  // namespace nao::walk
