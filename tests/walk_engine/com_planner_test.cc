#include "walk_engine/com_planner.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/models.h"

namespace nao::walk {
namespace {

constexpr double kHeight = 0.26;  // [m]
constexpr double kTick = 0.01;    // [s]

Eigen::Vector2d noReaction(std::int64_t) { return Eigen::Vector2d::Zero(); }

struct Way {
  StepFractions fractions;
  double max_step_x = 0.04;
};

class ComOverSteps : public testing::TestWithParam<Way> {};

// Whatever the steps, the zero moment point stays within the soles that stand, and ends at rest
// between the feet.
TEST_P(ComOverSteps, KeepsTheZeroMomentPointWithinTheSoles) {
  const auto model = test::robot("nao_h21_v33");
  const Tuning tuning;
  const Support soles(*model, 0);
  FootstepPlan plan(tuning, kTick);
  ComPlanner planner(*model, tuning, kTick);
  const ZmpQp pendulum(kHeight, 9.80665);
  plan.reset({Pose2{0, 0.05, 0}, Pose2{0, -0.05, 0}}, 0);
  planner.reset(kHeight, plan.calcZmp(0), 0);
  Goal goal;
  goal.kind = Goal::Kind::Velocity;
  goal.fractions = GetParam().fractions;
  goal.config.max_step_x = GetParam().max_step_x;
  plan.follow(goal, 1);
  double least = 1;
  for (int tick = 1; tick < 1200; ++tick) {
    if (tick == 800) {
      goal.kind = Goal::Kind::Stand;
      plan.follow(goal, tick);
    }
    plan.advance(tick, tick + planner.horizon());
    planner.advance(plan, tick, noReaction);
    const Eigen::Vector2d zmp = pendulum.calcZmp(planner.com());
    for (const SupportEdge& edge : soles.edges(Support::feetAt(plan, tick), 0)) {
      least = std::min(least, edge.offset - edge.normal.dot(zmp));
    }
  }
  EXPECT_GT(least, 0);
  EXPECT_LT(planner.velocity().norm(), 0.002);
  EXPECT_LT((planner.position() - plan.calcZmp(1200)).norm(), 0.003);
}

INSTANTIATE_TEST_SUITE_P(Ways, ComOverSteps,
                         testing::Values(Way{{1, 0, 0}}, Way{{1, 0, 0}, 0.08}, Way{{0, 1, 0}},
                                         Way{{0, 0, 1}}, Way{{-0.7, -0.7, 0.5}}));

}  // namespace
}  // namespace nao::walk
