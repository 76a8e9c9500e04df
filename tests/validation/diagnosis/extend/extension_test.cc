#include "validation/diagnosis/extend/extension.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/config.h"
#include "tests/core/temporary_folder.h"
#include "tests/support/models.h"

namespace nao::validation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const char* const kReport = R"({
  "shared": [{"cause": "command_latency", "effect": "command_latency", "rivals": [],
              "numbers": [{"parameter": "delay", "value": 0.004}]}],
  "joints": [
    {"joint": "LKneePitch", "findings": [
      {"cause": "backlash", "effect": "backlash", "numbers": [{"parameter": "width", "value": 0.01}],
       "rivals": [{"cause": "link_com.z", "numbers": [{"parameter": "z", "value": -0.004}]}]},
      {"cause": "kp_error", "effect": "kp_error", "numbers": [{"parameter": "part", "value": 0.02}],
       "rivals": [], "below_size_of_interest": true}],
     "adjustments": [{"cause": "kd_error", "effect": "kd_error",
                      "numbers": [{"parameter": "part", "value": -0.01}]}]},
    {"joint": "RAnkleRoll", "findings": [
      {"cause": "coulomb_friction", "effect": "coulomb_friction", "rivals": [],
       "numbers": [{"parameter": "torque", "value": 0.2}]}]}]})";

class ExtensionTest : public testing::Test {
 protected:
  ExtensionTest() {
    std::filesystem::copy(NAO_SOURCE_DIR "/robots/nao_h21_v33", folder_.path() + "/nao_h21_v33",
                          std::filesystem::copy_options::recursive);
    model_ = loadRobotModel(folder_.path(), "nao_h21_v33");
  }
  std::vector<EffectSetting> accept(const std::vector<std::string>& ids,
                                    const std::string& robot = "") const {
    return acceptedEffects(report_, {ids, robot}, *model_);
  }
  std::string complaint(const std::vector<std::string>& ids, const std::string& robot = "") const {
    try {
      accept(ids, robot);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "nothing";
  }
  void isReported(const std::string& places) {
    report_ = folder_.write("whole.json", R"({"shared": [], "joints": [)" + places + "]}");
  }

  TemporaryFolder folder_;
  std::shared_ptr<const RobotModel> model_;
  std::string report_ = folder_.write("report.json", kReport);
};

std::vector<std::string> namesOf(const std::vector<EffectSetting>& settings) {
  std::vector<std::string> names;
  for (const EffectSetting& one : settings) names.push_back(one.name);
  return names;
}

TEST_F(ExtensionTest, TakesWhatIsNamedAloneAndOfInterest) {
  EXPECT_THAT(namesOf(accept({})), ElementsAre("command_latency", "coulomb_friction"));
  EXPECT_TRUE(accept({})[0].joints.empty());
  EXPECT_THAT(accept({})[1].joints, ElementsAre(*model_->findJoint("RAnkleRoll")));
}

TEST_F(ExtensionTest, ARivalIsTakenByItsIdWithItsOwnNumbersAndNothingElse) {
  const std::vector<EffectSetting> one = accept({"link_com.z"});
  ASSERT_THAT(namesOf(one), ElementsAre("link_com"));
  EXPECT_EQ(one[0].parameters.at("z"), -0.004);
  EXPECT_EQ(one[0].parameters.at("x"), 0);  // not its nominal 5 mm
}

TEST_F(ExtensionTest, SmallAdjustmentsAreTheirJointsOwn) {
  const std::vector<EffectSetting> adjustments = reportedAdjustments(report_, {}, *model_);
  ASSERT_THAT(namesOf(adjustments), ElementsAre("kd_error", "kp_error"));
  EXPECT_EQ(adjustments[0].parameters.at("part"), -0.01);
  EXPECT_THAT(adjustments[0].joints, ElementsAre(*model_->findJoint("LKneePitch")));
}

TEST_F(ExtensionTest, ACauseThatMayBeSmallIsTakenOnce) {
  EXPECT_THAT(namesOf(accept({"kp_error"})), ElementsAre("kp_error"));
  EXPECT_THAT(namesOf(reportedAdjustments(report_, {{"kp_error"}, ""}, *model_)),
              ElementsAre("kd_error"));
}

TEST_F(ExtensionTest, NothingSmallStandsInForWhatHasNoName) {
  isReported(R"({"joint": "LKneePitch", "verdict": "partly_explained", "findings": [
    {"cause": "kp_error", "numbers": [{"parameter": "part", "value": 0.02}], "rivals": [],
     "below_size_of_interest": true}]})");
  EXPECT_TRUE(reportedAdjustments(report_, {}, *model_).empty());
}

// {"joint": `place`, one cause without a rival}
std::string told(const std::string& place, const std::string& cause, const std::string& number) {
  return R"({"joint": ")" + place + R"(", "findings": [{"cause": ")" + cause +
         R"(", "rivals": [], "numbers": [{"parameter": ")" + number + R"(", "value": 0.5}]}]})";
}

TEST_F(ExtensionTest, PutsARivalWhereItIs) {
  isReported(R"({"joint": "LHipPitch", "findings": [
    {"cause": "kp_error", "numbers": [{"parameter": "part", "value": 0.2}], "rivals": [
      {"cause": "kp_error at LHipRoll", "effect": "kp_error",
       "numbers": [{"parameter": "part", "value": 0.3}]},
      {"cause": "unknown", "effect": "", "numbers": []}]}]})");
  const std::vector<EffectSetting> effects = accept({"kp_error at LHipRoll"});
  ASSERT_EQ(effects.size(), 1u);
  EXPECT_EQ(effects[0].name, "kp_error");
  EXPECT_EQ(effects[0].parameters.at("part"), 0.3);
  EXPECT_THAT(effects[0].joints, ElementsAre(*model_->findJoint("LHipRoll")));
  EXPECT_THROW(accept({"unknown"}), InputError);  // --empirical takes what has no name
}

TEST_F(ExtensionTest, TakesWhatTheWholeRobotAndALegHave) {
  isReported(told("robot", "ground_friction", "scale") + ", " + told("LLeg", "kp_error", "part") +
             ", " + told("LHipPitch", "encoder_offset", "angle"));
  const std::vector<EffectSetting> effects = accept({});
  EXPECT_THAT(namesOf(effects), ElementsAre("ground_friction", "kp_error", "encoder_offset"));
  EXPECT_TRUE(effects[0].joints.empty());
  EXPECT_EQ(effects[1].joints.size(), 6u);
  EXPECT_THAT(effects[2].joints, ElementsAre(*model_->findJoint("LHipPitch")));
}

TEST_F(ExtensionTest, ARobotWithoutLimbsIsABody) {
  isReported(told("Body", "kp_error", "part"));
  const auto pendulum = test::robot("xl330_pendulum");
  EXPECT_EQ(acceptedEffects(report_, {}, *pendulum).front().joints.size(), pendulum->jointCount());
}

TEST_F(ExtensionTest, OfSeveralRobotsOneIsExtended) {
  isReported(told("sound/robot", "ground_friction", "scale") + ", " +
             told("faulty/LHipPitch", "kp_error", "part"));
  EXPECT_THAT(namesOf(accept({}, "faulty")), ElementsAre("kp_error"));
  EXPECT_EQ(complaint({}),
            "whole.json: is of several robots; expected --robot-id with one of: faulty, sound");
  EXPECT_EQ(complaint({}, "other"),
            "whole.json: is not of 'other'; expected --robot-id with one "
            "of: faulty, sound");
}

TEST_F(ExtensionTest, APlaceOrNumberThatIsNoneIsToldByItsName) {
  isReported(told("LTail", "kp_error", "part"));
  EXPECT_EQ(complaint({}), "whole.json: robot 'nao_h21_v33' has no joint or limb 'LTail'");
  isReported(told("LHipPitch", "kp_error", "gain"));
  EXPECT_EQ(complaint({}), "whole.json: kp_error has no parameter 'gain', expected one of: part");
}

TEST_F(ExtensionTest, SaysWhatItCouldHaveTaken) {
  EXPECT_EQ(complaint({"play"}),
            "--accept play: expected a cause of report.json, one of: backlash, command_latency, "
            "coulomb_friction, kp_error, link_com.z");
  folder_.write("report.json", "{}");
  EXPECT_THAT(complaint({}), HasSubstr("report.json: expected the report.json of a diagnosis"));
}

TEST_F(ExtensionTest, TheNewRobotIsTheOldOneWithTheDeviationsAdded) {
  std::vector<EffectSetting> causes = accept({"backlash", "coulomb_friction"});
  writeExtendedRobot(folder_.path(), "nao_7", *model_, causes, "from a test");
  const auto extended = loadRobotModel(folder_.path(), "nao_7");
  EXPECT_EQ(extended->jointCount(), model_->jointCount());
  double knee = 0, hip = 0, friction = 0;
  for (const EffectSetting& effect : extended->effects) {
    for (const Joint joint : effect.joints) {
      const std::string& name = extended->actuators[index(joint)].name;
      if (effect.name == "backlash" && name == "LKneePitch") knee = effect.parameters.at("width");
      if (effect.name == "backlash" && name == "LHipPitch") hip = effect.parameters.at("width");
      if (effect.name == "coulomb_friction") friction = effect.parameters.at("torque");
    }
  }
  EXPECT_NEAR(knee, 0.024435 + 0.01, 1e-9);
  EXPECT_NEAR(hip, 0.024435, 1e-9);
  EXPECT_NEAR(friction, 0.2, 1e-9);
  EXPECT_THROW(writeExtendedRobot(folder_.path(), "nao_7", *model_, causes, ""), InputError);
}

}  // namespace
}  // namespace nao::validation
