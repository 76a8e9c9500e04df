#include "validation/diagnosis/extend/optimise.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/check.h"
#include "tests/support/models.h"
#include "validation/log/simulated_recording.h"

namespace nao::validation {
namespace {

std::shared_ptr<RobotModel> pendulum() {
  auto model = std::make_shared<RobotModel>(*nao::test::robot("xl330_pendulum"));
  model->cycle = std::chrono::milliseconds(10);
  return model;
}

LogSet setWith(const std::vector<EffectSetting>& extra) {
  RecordingPlan plan;
  plan.model = pendulum();
  plan.extra = extra;
  plan.repeats = 1;
  plan.step = std::chrono::milliseconds(1);
  for (const double pace : {1.0, 2.3}) {
    plan.motions.push_back({"pace" + std::to_string(pace), Split::Fit, 4, [pace](double t) {
                              return JointArray<double>(1, 1.2 * std::sin(pace * t));
                            }});
  }
  return recordSimulated(plan);
}

TEST(Optimise, FindsTheChosenNumbersAndSaysHowSure) {
  const LogSet set = setWith(
      {{"coulomb_friction", {{"torque", 0.03}}, {}, ""}, {"kp_error", {{"part", 0.2}}, {}, ""}});
  const auto model = pendulum();
  const PreparedSet prepared = prepareSet(set, model, 1);
  const auto free = parseFree("kp_error.part,coulomb_friction.torque@pendulum", *model);
  const Optimised found = optimise(prepared, free, {});
  ASSERT_EQ(found.numbers.size(), 2u);
  EXPECT_NEAR(found.numbers[0].found.value, 0.03, 0.003);  // sorted by effect
  EXPECT_NEAR(found.numbers[1].found.value, 0.2, 0.02);
  for (const OptimisedNumber& number : found.numbers) {
    EXPECT_LT(number.found.low, number.found.deviation);
    EXPECT_GT(number.found.high, number.found.deviation);
    EXPECT_FALSE(number.at_bound);
  }
  EXPECT_LT(found.after, 0.1 * found.before);
  EXPECT_EQ(found.settings.size(), 2u);
}

TEST(Optimise, SaysWhatCanNotBeFitted) {
  const auto model = pendulum();
  EXPECT_THROW(parseFree("glue.torque", *model), InputError);
  EXPECT_THROW(parseFree("backlash.depth", *model), InputError);
  EXPECT_THROW(parseFree("backlash.width@LKneePitch", *model), InputError);
  EXPECT_THROW(parseFree("ground_friction.factor", *model), InputError);
  EXPECT_THROW(parseFree("", *model), InputError);
}

}  // namespace
}  // namespace nao::validation
