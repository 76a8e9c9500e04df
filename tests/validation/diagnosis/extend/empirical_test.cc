#include "validation/diagnosis/extend/empirical.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/core/temporary_folder.h"
#include "tests/support/models.h"
#include "validation/diagnosis/replay/replay.h"
#include "validation/log/simulated_recording.h"

namespace nao::validation {
namespace {

std::shared_ptr<RobotModel> pendulum() {
  auto model = std::make_shared<RobotModel>(*nao::test::robot("xl330_pendulum"));
  model->cycle = std::chrono::milliseconds(10);
  return model;
}

// Three motions, with a torque that no cause stands for.
LogSet recorded(const EffectSetting& torque, int repeats = 1) {
  RecordingPlan plan;
  plan.model = pendulum();
  plan.extra = {torque};
  plan.repeats = repeats;
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

EmpiricalFit fitTo(const LogSet& set, const std::vector<std::string>& features) {
  const PreparedSet prepared = prepareSet(set, pendulum(), 1);
  EmpiricalFit fit = fitEmpirical(prepared.joints[0], features);
  fit.setting.joints = {toJoint(0)};
  return fit;
}

TEST(Empirical, ATorqueWithoutANameIsPredictedWhereItWasNotFitted) {
  const LogSet set =
      recorded({"cogging", {{"torque", 0.05}, {"per_turn", 6}, {"phase", 0.3}}, {}, ""});
  const EmpiricalFit fit = fitTo(set, {"sin and cos of 6 q", "a"});
  EXPECT_LT(fit.after, 0.3 * fit.before);
  EXPECT_EQ(fit.left_out, std::vector<std::string>{"a"});
  EXPECT_LT(testError(set, {fit.setting}), 0.4 * testError(set, {}));
}

// Told 0.04 rad and a fifth of the speed beside where they are.
TEST(Empirical, SoIsFrictionNearAnAngleAndNearASpeed) {
  const LogSet spot = recorded(
      {"empirical_torque", {{"constant", 0}, {"spot", -0.05}, {"spot_angle", 0.44}}, {}, ""});
  EXPECT_LT(testError(spot, {fitTo(spot, {"sgn v near q = 0.4"}).setting}),
            0.4 * testError(spot, {}));
  const LogSet band =
      recorded({"empirical_torque",
                {{"constant", 0}, {"band", -0.15}, {"band_speed", 1.5}, {"band_width", 0.4}},
                {},
                ""});
  EXPECT_LT(testError(band, {fitTo(band, {"sgn v near |v| = 1.20"}).setting}),
            0.4 * testError(band, {}));
}

// A brake that presses and lets go.
TEST(Empirical, SoIsFrictionThatComesAndGoes) {
  const LogSet set =
      recorded({"empirical_torque",
                {{"constant", 0}, {"sign", -0.05}, {"sign_hum_sin", 0.05}, {"hum", 0.5}},
                {},
                ""});
  EXPECT_LT(testError(set, {fitTo(set, {"sgn v with sin and cos of 0.5 Hz"}).setting}),
            0.4 * testError(set, {}));
}

// A rough patch went with 4 q first, then a ripple of 17 q beside it took its place.
TEST(Empirical, HasOneRippleThatOfTheBestFeature) {
  const LogSet set =
      recorded({"empirical_torque",
                {{"constant", 0}, {"sign", -0.05}, {"sign_sin", 0.05}, {"ripple", 4}},
                {},
                ""});
  const EmpiricalFit fit =
      fitTo(set, {"sgn v", "sgn v with sin and cos of 4 q", "sin and cos of 17 q"});
  EXPECT_EQ(fit.left_out, std::vector<std::string>{"sin and cos of 17 q"});
  EXPECT_NEAR(fit.setting.parameters.at("ripple"), 4, 0.6);
  EXPECT_LT(fit.after, 0.4 * fit.before);
}

// A ripple of the torque, of which the report of a whole robot says no more than where it is.
TEST(Empirical, LooksForTheShapeThatAWholeRobotsReportDoesNotTell) {
  const LogSet set =
      recorded({"cogging", {{"torque", 0.05}, {"per_turn", 6}, {"phase", 0.3}}, {}, ""}, 5);
  const PreparedSet prepared = prepareSet(set, pendulum(), 1);
  const auto features = remainingFeatures(prepared.joints[0]);
  ASSERT_FALSE(features.empty());
  EXPECT_EQ(features[0], "sin and cos of 6 q");
  const EmpiricalFit fit = fitEmpirical(prepared.joints[0], features);
  EXPECT_LT(fit.after, 0.3 * fit.before);
}

TEST(Empirical, HasNoShapeWithoutRepeats) {
  const LogSet set =
      recorded({"cogging", {{"torque", 0.05}, {"per_turn", 6}, {"phase", 0.3}}, {}, ""});
  EXPECT_TRUE(remainingFeatures(prepareSet(set, pendulum(), 1).joints[0]).empty());
}

TEST(Empirical, ReadsThePlacesThatAWholeRobotsReportNames) {
  const TemporaryFolder folder;
  const std::string file = folder.write("report.json", R"json({"level": "robot", "joints": [
    {"joint": "LLeg", "signature": "LHipRoll, torso roll, LKneePitch"},
    {"joint": "RLeg", "signature": "LHipRoll"}]})json");
  const auto unknowns = unknownJoints(file);
  ASSERT_EQ(unknowns.size(), 3u);
  EXPECT_EQ(unknowns[0].joint, "LHipRoll");
  EXPECT_EQ(unknowns[1].joint, "torso roll");
  EXPECT_EQ(unknowns[2].joint, "LKneePitch");
  EXPECT_TRUE(unknowns[0].features.empty());
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
