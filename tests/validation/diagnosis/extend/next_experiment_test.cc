#include "validation/diagnosis/extend/next_experiment.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "motion/timeline/motion_file.h"
#include "tests/core/temporary_folder.h"
#include "tests/support/models.h"

namespace nao::validation {
namespace {

std::shared_ptr<const RobotModel> pendulum() { return nao::test::robot("xl330_pendulum"); }

// Dry friction and grease: alike at one speed only.
Ambiguity ambiguous() {
  const std::vector<Joint> joint{toJoint(0)};
  return {"pendulum",
          {"coulomb_friction", "viscous_friction"},
          {{"coulomb_friction", {{"torque", 0.03}}, joint, ""},
           {"viscous_friction", {{"coefficient", 0.03}}, joint, ""}},
          ""};
}

TEST(NextExperiment, TakesTheMotionThatSeparatesMost) {
  const auto found = planExperiments(pendulum(), ambiguous(), 6, 1);
  ASSERT_GE(found.size(), 5u);
  for (std::size_t i = 1; i < found.size(); ++i) {
    EXPECT_GE(found[i - 1].separation, found[i].separation);
  }
  EXPECT_GT(found.front().separation, 2 * found.back().separation);
}

TEST(NextExperiment, WritesAMotionThatPlays) {
  const auto model = nao::test::robot("nao_h21_v33");
  const auto motions = candidateMotions(model, *model->findJoint("LKneePitch"));
  const TemporaryFolder folder;
  const std::string file = folder.path() + "/next.motion";
  writeMotion(motions.front(), *model, file);
  const motion::Timeline timeline = motion::loadMotion(file, *model);
  EXPECT_FALSE(timeline.curves.empty());
}

TEST(NextExperiment, ReadsWhatAReportCouldNotDecide) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("report.json", R"({"joints": [{"joint": "pendulum", "findings": [
    {"cause": "torque_bias", "effect": "torque_bias", "experiment": "turn the base",
     "numbers": [{"parameter": "torque", "value": 0.02}],
     "rivals": [{"cause": "encoder_offset", "numbers": [{"parameter": "angle", "value": 0.1}]}]}
  ]}]})");
  const auto found = ambiguitiesOf(file, *pendulum());
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].causes, (std::vector<std::string>{"torque_bias", "encoder_offset"}));
  EXPECT_DOUBLE_EQ(found[0].settings[1].parameters.at("angle"), 0.1);
  EXPECT_EQ(found[0].level, "joint");
  folder.write("report.json", R"({"joints": []})");
  EXPECT_THROW(ambiguitiesOf(file, *pendulum()), InputError);
}

TEST(NextExperiment, SaysWhatAReportMayNotHold) {
  const TemporaryFolder folder;
  const auto complaint = [&](const std::string& place, const std::string& parameter) {
    const std::string numbers = R"("numbers": [{"parameter": ")" + parameter + R"(", "value": 1}])";
    const std::string file = folder.write(
        "report.json", R"({"joints": [{"joint": ")" + place +
                           R"(", "findings": [{"cause": "kp_error", )" + numbers +
                           R"(, "rivals": [{"cause": "kd_error", )" + numbers + "}]}]}]}");
    try {
      ambiguitiesOf(file, *nao::test::robot("nao_h21_v33"));
    } catch (const InputError& error) {
      return folder.withoutPath(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint("LKneePitch", "part"), "");
  EXPECT_NE(complaint("LLeg", "part").find("expected a joint at joint level"), std::string::npos);
  EXPECT_NE(complaint("LKneePitch", "width").find("no effect 'kp_error' with 'width'"),
            std::string::npos);
}

TEST(NextExperiment, ReadsRivalsElsewhereOfARobot) {
  const TemporaryFolder folder;
  const std::string file =
      folder.write("report.json", R"({"level": "robot", "joints": [{"joint": "7/LLeg", "findings": [
    {"cause": "kp_error", "effect": "kp_error", "numbers": [{"parameter": "part", "value": -0.3}],
     "rivals": [{"cause": "imu_bias.gyro_y at robot", "effect": "imu_bias",
                 "numbers": [{"parameter": "gyro_y", "value": 0.1}]},
                {"cause": "kp_error at LHipRoll", "effect": "kp_error",
                 "numbers": [{"parameter": "part", "value": -0.5}]}]}
  ]}]})");
  const auto model = nao::test::robot("nao_h21_v33");
  const auto found = ambiguitiesOf(file, *model);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].level, "robot");
  ASSERT_EQ(found[0].settings.size(), 3u);
  EXPECT_EQ(found[0].settings[0].joints.size(), 6u);
  EXPECT_TRUE(found[0].settings[1].joints.empty());
  EXPECT_EQ(found[0].settings[2].joints, std::vector<Joint>{*model->findJoint("LHipRoll")});
}

// Grease in a shoulder shows where arms swing.
TEST(NextExperiment, OfAStandingRobotIsOneItCanStand) {
  const auto model = nao::test::robot("nao_h21_v33");
  const Ambiguity ambiguous{
      "robot",
      {"viscous_friction at LShoulderPitch", "viscous_friction at HeadYaw"},
      {{"viscous_friction", {{"coefficient", 0.3}}, {*model->findJoint("LShoulderPitch")}, ""},
       {"viscous_friction", {{"coefficient", 0.3}}, {*model->findJoint("HeadYaw")}, ""}},
      "",
      "robot"};
  const auto found = planExperiments(model, ambiguous, 6, 2);
  ASSERT_EQ(found.size(), 5u);
  EXPECT_EQ(found.front().motion.name, "arms");
  EXPECT_GT(found.front().separation, 3 * found.back().separation);
  EXPECT_GT(found.front().motion.duration, 5);
}

TEST(NextExperiment, SaysThatNoMotionTellsThemApart) {
  const auto text = [](double separation) {
    const PlannedMotion one{{"sway", Split::Fit, 8, {}}, separation};
    return toText(reportPlan(ambiguous(), {one}, *pendulum(), 6));
  };
  EXPECT_EQ(text(12).find("No motion"), std::string::npos) << text(12);
  EXPECT_NE(text(0.8).find("No motion here tells them apart"), std::string::npos) << text(0.8);
}

}  // namespace
}  // namespace nao::validation
