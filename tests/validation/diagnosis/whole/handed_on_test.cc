#include "validation/diagnosis/whole/handed_on.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/config.h"
#include "tests/core/temporary_folder.h"
#include "tests/support/models.h"
#include "validation/diagnosis/report/report_file.h"

namespace nao::validation {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const char* const kReport = R"({"level": "joint",
  "shared": [{"cause": "command_latency", "rivals": [],
              "numbers": [{"parameter": "delay", "deviation": 0.004}]}],
  "joints": [
    {"joint": "LKneePitch", "findings": [
      {"cause": "backlash", "numbers": [{"parameter": "width", "deviation": 0.01}],
       "rivals": [{"cause": "torque_limit", "numbers": [{"parameter": "part", "deviation": 2}]},
                  {"cause": "unknown", "numbers": []}]},
      {"cause": "kp_error", "numbers": [{"parameter": "part", "deviation": 0.02}],
       "rivals": [], "below_size_of_interest": true}]},
    {"joint": "LLeg", "findings": [
      {"cause": "link_mass", "numbers": [{"parameter": "part", "deviation": 0.1}],
       "rivals": [{"cause": "kp_error at LHipRoll",
                   "numbers": [{"parameter": "part", "deviation": -0.2}]}]}]}]})";

std::string textOf(const HandedOn& one) {
  return one.cause + " at " + one.place + (one.alone ? "" : "?");
}

std::vector<std::string> textsOf(const std::vector<HandedOn>& all) {
  std::vector<std::string> texts;
  for (const HandedOn& one : all) texts.push_back(textOf(one));
  return texts;
}

std::string complaint(const TemporaryFolder& folder, const std::string& text) {
  try {
    readHandedOn(folder.write("report.json", text), "limb");
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "nothing";
}

TEST(HandedOn, IsWhatALowerLevelNamesAndTheRivalsOfIt) {
  const TemporaryFolder folder;
  const auto all = readHandedOn(folder.write("report.json", kReport), "robot");
  EXPECT_THAT(textsOf(all), ElementsAre("command_latency at robot", "backlash at LKneePitch?",
                                        "torque_limit at LKneePitch?", "link_mass at LLeg?",
                                        "kp_error at LHipRoll?"));
  EXPECT_THAT(all[1].x, ElementsAre(0.01));
}

TEST(HandedOn, OfSeveralRobotsGoesToItsOwn) {
  const TemporaryFolder folder;
  const auto all = readHandedOn(folder.write("report.json", R"({"level": "joint",
    "shared": [{"cause": "command_latency", "rivals": [], "robot_id": "7",
                "numbers": [{"parameter": "delay", "deviation": 0.004}]}],
    "joints": [{"joint": "8/LKneePitch", "findings": [
      {"cause": "backlash", "rivals": [], "numbers": [{"parameter": "width", "deviation": 0.01}]}
    ]}]})"),
                                "robot");
  EXPECT_THAT(textsOf(handedOnTo("7", all)), ElementsAre("command_latency at robot"));
  EXPECT_THAT(textsOf(handedOnTo("8", all)), ElementsAre("backlash at LKneePitch"));
  EXPECT_NO_THROW(requireRobots(all, {"7", "8"}));
  try {
    requireRobots(all, {"8", "9"});
    ADD_FAILURE() << "nobody missed robot 7";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("is of robot 7 too, of which the set has no run"));
  }
}

TEST(HandedOn, IsOfALowerLevelAlone) {
  const TemporaryFolder folder;
  EXPECT_THAT(complaint(folder, R"({"level": "limb", "shared": [], "joints": []})"),
              HasSubstr("is of the limb level, expected one below limb"));
  EXPECT_THAT(complaint(folder, R"({"level": "joint", "shared": [], "joints": []})"),
              HasSubstr("names no cause"));
  EXPECT_THAT(complaint(folder, "{}"), HasSubstr("expected the report.json of a diagnosis"));
}

TEST(HandedOn, StandsAmongTheCausesOfALevelThatDoesNotTryItByItself) {
  const auto model = test::robot("nao_h21_v33");
  std::vector<Joint> all;
  for (const Actuator& one : model->actuators) all.push_back(*model->findJoint(one.name));
  const std::vector<Joint> leg = jointsOf(*model, "LLeg", all);
  std::vector<PlacedCause> causes = limbCauses(*model, "LLeg", all);
  const std::size_t tried = causes.size();
  const std::vector<HandedOn> handed_on{{"LKneePitch", "backlash", {0.01, 0}, true},
                                        {"LKneePitch", "rate_limit", {5, 0}, true},
                                        {"LKneePitch", "motor_inertia", {0.5}, true},
                                        {"RKneePitch", "backlash", {0.01, 0}, true},
                                        {"robot", "command_latency", {0.004}, true}};
  const auto found = provisionalAmong(causes, handed_on, leg, *model, all);
  ASSERT_EQ(found.size(), 3u);  // the others are none of this limb's
  ASSERT_EQ(causes.size(), tried + 1);
  EXPECT_LT(found[0].chosen.cause, tried);
  EXPECT_EQ(found[1].chosen.cause, tried);
  EXPECT_EQ(causes.back().cause.id, "rate_limit");
  EXPECT_EQ(causes.back().joints, std::vector<Joint>{*model->findJoint("LKneePitch")});
  // Robots differ by it: it is looked for now.
  const PlacedCause& inertia = causes[found[2].chosen.cause];
  EXPECT_EQ(inertia.cause.id + " at " + inertia.place, "motor_inertia at LKneePitch");
  EXPECT_TRUE(inertia.isTried());
}

// Of robots on their feet a hold has a phase too, of which a joint knows nothing.
TEST(HandedOn, WithoutAPhaseAHoldIsTriedOnTheFeetToo) {
  const auto model = test::robot("nao_h21_v33");
  std::vector<Joint> all;
  for (const Actuator& one : model->actuators) all.push_back(*model->findJoint(one.name));
  std::vector<PlacedCause> causes = robotCauses(*model, all);
  const auto found =
      provisionalAmong(causes, {{"robot", "command_hold", {0.02}, true}}, {}, *model, all);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].chosen.x, ElementsAre(0.02, 0));
}

TEST(HandedOn, WhatNoSearchCanTryIsTold) {
  const auto model = test::robot("nao_h21_v33");
  const std::vector<Joint> measured{*model->findJoint("LKneePitch")};
  const std::vector<HandedOn> handed_on{{"LKneePitch", "backlash", {0.01, 0}, true},
                                        {"LHipYawPitch", "backlash", {0.01, 0}, true},
                                        {"LKneePitch", "gremlins", {0.01}, true},
                                        {"robot", "command_latency", {0.004}, true}};
  const auto at_limb = notTriedAmong(handed_on, false, *model, measured);
  ASSERT_EQ(at_limb.size(), 3u);
  EXPECT_EQ(at_limb[0].was.place, "LHipYawPitch");
  EXPECT_EQ(at_limb[0].before.parameter, "width");
  EXPECT_THAT(at_limb[1].outcome, HasSubstr("no such cause"));
  EXPECT_THAT(at_limb[2].outcome, HasSubstr("more than a limb"));
  EXPECT_EQ(notTriedAmong(handed_on, true, *model, measured).size(), 2u);
}

TEST(ReportFile, NamesItsNominalRobot) {
  const TemporaryFolder folder;
  const std::string file = folder.write("report.json", R"({"model": "nao_h25_v50"})");
  EXPECT_EQ(reportedModel(file, ""), "nao_h25_v50");
  EXPECT_EQ(reportedModel(file, "nao_h25_v50"), "nao_h25_v50");
  EXPECT_THROW(reportedModel(file, "nao_h21_v33"), InputError);
  EXPECT_THROW(reportedModel(folder.write("other.json", "{}"), ""), InputError);
}

}  // namespace
}  // namespace nao::validation
