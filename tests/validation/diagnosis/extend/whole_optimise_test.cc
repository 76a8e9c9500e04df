#include "validation/diagnosis/extend/whole_optimise.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/support/models.h"
#include "validation/log/floor_recording.h"
#include "validation/merge_effects.h"

namespace nao::validation {
namespace {

LogSet squats(const std::vector<EffectSetting>& extra) {
  FloorPlan plan;
  plan.model = test::robot("nao_h21_v33");
  plan.motions = {{"squat", Split::Fit, 3, {}}};
  plan.repeats = 4;
  plan.extra = extra;
  LogSet set = recordOnFloor(plan);
  set.name = "squats";
  set.runs.back().split = Split::Test;
  return set;
}

TEST(WholeOptimise, FindsTheChosenNumbersOfARobotOnItsFeet) {
  const auto model = test::robot("nao_h21_v33");
  const Joint shoulder = *model->findJoint("LShoulderPitch");
  const LogSet set = squats({{"command_latency", {{"delay", 0.04}}, {}, ""},
                             {"kp_error", {{"part", -0.6}}, {shoulder}, ""}});
  const auto free = parseFree("kp_error.part@LShoulderPitch,command_latency.delay", *model, true);
  const Optimised found = optimiseWhole(set, model, free, {2, 6, 0});
  ASSERT_EQ(found.numbers.size(), 2u);
  EXPECT_EQ(nameOf(found.numbers[0].what), "command_latency.delay");
  EXPECT_NEAR(found.numbers[0].found.deviation, 0.04, 0.004);  // less than half a cycle
  EXPECT_NEAR(found.numbers[1].found.deviation, -0.6, 0.06);   // a tenth
  // A value is what a robot's file would say: with what this one has already.
  const double has =
      presentDeviation(*model, index(shoulder), "command_latency", "delay", sim::standardEffects());
  EXPECT_GT(has, 0);
  EXPECT_DOUBLE_EQ(found.numbers[0].found.value, found.numbers[0].found.deviation + has);
  for (const OptimisedNumber& number : found.numbers) {
    EXPECT_LT(number.found.low, number.found.deviation);
    EXPECT_GT(number.found.high, number.found.deviation);
    EXPECT_FALSE(number.at_bound);
  }
  EXPECT_LT(found.after, 0.5 * found.before);
  EXPECT_EQ(found.select_before, 0);  // there are no such runs
}

// One and a half coarse steps. A twentieth is granted: walks were told 0.2 ms too late by step
// errors of the nominal model.
TEST(WholeOptimise, ADelayBetweenCoarseStepsIsToldAsItIs) {
  const auto model = test::robot("nao_h21_v33");
  const LogSet set = squats({{"command_latency", {{"delay", 0.003}}, {}, ""}});
  const auto free = parseFree("command_latency.delay", *model, true);
  const FoundNumber found = optimiseWhole(set, model, free, {2, 6, 0}).numbers[0].found;
  EXPECT_NEAR(found.deviation, 0.003, 0.00015);
  EXPECT_LT(found.low, 0.003);
  EXPECT_GT(found.high, 0.003);
}

TEST(WholeOptimise, TellsANumberThatTheSetDoesNotShow) {
  const auto model = test::robot("nao_h21_v33");
  const auto free = parseFree("stribeck_friction.speed", *model, true);  // without its torque
  EXPECT_THROW(optimiseWhole(squats({}), model, free, {2, 2, 0}), InputError);
}

TEST(WholeOptimise, NumbersOfTheGroundAreForAWholeRobotAlone) {
  const auto model = test::robot("nao_h21_v33");
  EXPECT_EQ(parseFree("ground_friction.scale", *model, true).size(), 1u);
  EXPECT_THROW(parseFree("ground_friction.scale", *model), InputError);
}

}  // namespace
}  // namespace nao::validation
