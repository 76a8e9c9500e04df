#include "validation/diagnosis/empirical.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/temporary_folder.h"
#include "tests/support/models.h"
#include "validation/diagnosis/replay.h"
#include "validation/log/simulated_recording.h"

namespace nao::validation {
namespace {

std::shared_ptr<RobotModel> pendulum() {
  auto model = std::make_shared<RobotModel>(*nao::test::robot("xl330_pendulum"));
  model->cycle = std::chrono::milliseconds(10);
  return model;
}

// Two runs each of three motions, with a ripple in the torque that no cause stands for.
LogSet rippledSet(double torque) {
  RecordingPlan plan;
  plan.model = pendulum();
  plan.extra = {{"cogging", {{"torque", torque}, {"per_turn", 6}, {"phase", 0.3}}, {}, ""}};
  plan.repeats = 1;
  plan.step = std::chrono::milliseconds(1);
  for (const auto& [name, pace, split] :
       {std::tuple<const char*, double, Split>{"slow", 1.0, Split::Fit},
        {"quick", 2.3, Split::Fit},
        {"other", 1.6, Split::Test}}) {
    plan.motions.push_back({name, split, 4, [pace = pace](double t) {
                              return JointArray<double>(1, 1.2 * std::sin(pace * t) + 0.3 * t);
                            }});
  }
  return recordSimulated(plan);
}

double testError(const LogSet& set, const std::vector<EffectSetting>& extra) {
  auto model = pendulum();
  for (const EffectSetting& one : extra) model->effects.push_back(one);
  const PreparedSet prepared = prepareSet(set, model, 1);
  return replayJoint(*prepared.joints[0].simulator, {}, JointNoise{}, 2, {Split::Test}).rmse;
}

TEST(Empirical, ATorqueWithoutANameIsPredictedWhereItWasNotFitted) {
  const LogSet set = rippledSet(0.05);
  const PreparedSet prepared = prepareSet(set, pendulum(), 1);
  EmpiricalFit fit = fitEmpirical(prepared.joints[0], {"sin and cos of 6 q", "a"});
  EXPECT_LT(fit.after, 0.3 * fit.before);
  EXPECT_EQ(fit.left_out, std::vector<std::string>{"a"});
  fit.setting.joints = {toJoint(0)};
  EXPECT_LT(testError(set, {fit.setting}), 0.4 * testError(set, {}));
}

TEST(Empirical, ReadsTheSignaturesOfAReport) {
  const TemporaryFolder folder;
  const std::string file = folder.write("report.json", R"json({"joints": [
    {"joint": "A", "signature": "sin and cos of 18 q (62 %), then v|v| (8 %)"},
    {"joint": "B", "signature": ""}]})json");
  const auto unknowns = unknownJoints(file);
  ASSERT_EQ(unknowns.size(), 1u);
  EXPECT_EQ(unknowns[0].joint, "A");
  EXPECT_EQ(unknowns[0].features, (std::vector<std::string>{"sin and cos of 18 q", "v|v|"}));
  folder.write("report.json", R"({"joints": []})");
  EXPECT_THROW(unknownJoints(file), InputError);
}

}  // namespace
}  // namespace nao::validation
