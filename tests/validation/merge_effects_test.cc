#include "validation/merge_effects.h"

#include <gtest/gtest.h>

#include "tests/support/models.h"

namespace nao::validation {
namespace {

RobotModel playful(double width) {
  RobotModel model = *nao::test::pendulum(1, 0.2);
  model.effects = {{"backlash", {{"width", width}}, {}, ""}};
  return model;
}

double width(const RobotModel& model, double cause) {
  const auto effects = mergedEffects(model, {{"backlash", {{"width", cause}}, {toJoint(0)}, ""}},
                                     sim::standardEffects());
  EXPECT_EQ(effects.size(), 1u);
  return effects.back().parameters.at("width");
}

TEST(MergedEffects, AddADeviationToWhatTheModelHas) {
  EXPECT_DOUBLE_EQ(width(playful(0.02), 0.01), 0.03);
  EXPECT_DOUBLE_EQ(width(playful(0.02), -0.015), 0.005);
}

TEST(MergedEffects, StayWithinBounds) { EXPECT_DOUBLE_EQ(width(playful(0.02), -0.05), 0); }

TEST(MergedEffects, AppendWhatTheModelLacks) {
  const auto effects =
      mergedEffects(playful(0.02), {{"kp_error", {{"part", 0.2}}, {}, ""}}, sim::standardEffects());
  ASSERT_EQ(effects.size(), 2u);
  EXPECT_EQ(effects[1].name, "kp_error");
}

TEST(MergedEffects, KnowWhatIsPresent) {
  const RobotModel model = playful(0.02);
  EXPECT_DOUBLE_EQ(presentDeviation(model, 0, "backlash", "width", sim::standardEffects()), 0.02);
  EXPECT_DOUBLE_EQ(presentDeviation(model, 0, "kp_error", "part", sim::standardEffects()), 0);
}

}  // namespace
}  // namespace nao::validation
