#include "validation/diagnosis/whole/whole_diagnosis.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "core/suspend.h"
#include "tests/support/models.h"
#include "validation/log/floor_recording.h"
#include "validation/log/simulated_recording.h"

namespace nao::validation {
namespace {

// Small enough for a test: one short motion, few causes. What the whole catalogue makes of whole
// sets is measured by commands.
LogSet record(const std::vector<EffectSetting>& hidden, double noise, std::uint64_t seed,
              std::string motion = "arms") {
  FloorPlan plan;
  plan.model = test::robot("nao_h21_v33");
  plan.motions = {{std::move(motion), Split::Fit, 1.5, {}}};
  plan.repeats = 3;
  plan.seed = seed;
  for (EffectSetting effect : plan.model->noise) {
    if (effect.name == "floor_friction" || effect.name == "start_pose") continue;
    if (effect.name == "process_noise") effect.parameters["sd"] *= noise;
    plan.extra.push_back(effect);
  }
  plan.extra.insert(plan.extra.end(), hidden.begin(), hidden.end());
  return recordOnFloor(plan);
}

const std::vector<std::string> kShoulders{
    "kp_error at LShoulderPitch", "kp_error at RShoulderPitch", "encoder_offset at LShoulderPitch"};

WholeDiagnosis diagnose(const LogSet& set, std::vector<std::string> only = kShoulders,
                        std::vector<HandedOn> handed_on = {},
                        std::function<void(const std::string&, double)> progress = {}) {
  WholeDiagnosisOptions options;
  options.progress = std::move(progress);
  options.only = std::move(only);
  options.handed_on = std::move(handed_on);
  options.effort.base_runs = options.effort.step_runs = 12;
  options.effort.fit_runs = 3;
  options.effort.finalists = 3;
  return diagnoseWhole(set, test::robot("nao_h21_v33"), options);
}

EffectSetting weakShoulder() {
  const Joint shoulder = *test::robot("nao_h21_v33")->findJoint("LShoulderPitch");
  return {"kp_error", {{"part", -0.4}}, {shoulder}, ""};
}

std::string placesOf(const WholeDiagnosis& diagnosis) {
  std::string text;
  for (const JointVerdict& place : diagnosis.set.joints) {
    for (const Finding* one : place.named()) text += one->cause + " at " + place.joint + "; ";
  }
  return text;
}

TEST(WholeDiagnosis, OfTwoRobotsBlamesTheFaultyOne) {
  LogSet set = record({}, 1, 2);
  const LogSet faulty = record({weakShoulder()}, 1, 3);
  for (LogRun run : faulty.runs) {
    run.robot_id = "other";
    run.file = "other_" + run.file;
    set.runs.push_back(run);
  }
  std::vector<double> parts;
  const WholeDiagnosis diagnosis =
      diagnose(set, kShoulders, {{"LShoulderPitch", "kp_error", {-0.3}, true, "other"}},
               [&](const std::string&, double part) { parts.push_back(part); });
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_GE(parts.size(), 6u);  // scatter, looks and fits of both
  EXPECT_EQ(parts.front(), 0);
  EXPECT_EQ(std::count(parts.begin(), parts.end(), 0.5), 1);  // where the second robot begins
  EXPECT_LT(parts.back(), 1);
  ASSERT_EQ(placesOf(diagnosis), "kp_error at other/LShoulderPitch; ");
  ASSERT_EQ(diagnosis.handed_on.size(), 1u);
  EXPECT_EQ(diagnosis.handed_on[0].was.place, "other/LShoulderPitch");
  const Finding& found = *diagnosis.set.joints.back().named()[0];
  EXPECT_LT(found.numbers[0].low, -0.4);
  EXPECT_GT(found.numbers[0].high, -0.4);
  EXPECT_LT(found.numbers[0].high, -0.05);  // the smallest of interest
  const auto json =
      nlohmann::json::parse(toJson(diagnosis, {"set", "nao_h21_v33", "command", "robot"}));
  EXPECT_EQ(json["level"], "robot");
  EXPECT_EQ(json["second_moments"].size(), 2u);
  EXPECT_FALSE(json["gait"].empty());
}

TEST(WholeDiagnosis, SaysUnfinishedOutOfBudgetNeverUnknown) {
  WholeDiagnosisOptions options;
  options.only = kShoulders;
  options.effort.base_runs = options.effort.step_runs = 4;
  options.seconds = 1e-6;
  const WholeDiagnosis diagnosis =
      diagnoseWhole(record({weakShoulder()}, 1, 3), test::robot("nao_h21_v33"), options);
  EXPECT_EQ(diagnosis.set.verdict, Verdict::Unfinished);
  EXPECT_EQ(placesOf(diagnosis), "");
  EXPECT_GE(diagnosis.set.joints.front().not_tried.size(), kShoulders.size());
}

const std::vector<std::string> kInertialUnit{"imu_misalignment.x", "imu_misalignment.y",
                                             "imu_bias.acc_x",     "imu_bias.gyro_y",
                                             "imu_scale.acc",      "kp_error at LShoulderPitch"};

// A bias along one axis reads like a turned board at rest; what the others say tells them apart.
TEST(WholeDiagnosis, TellsWhatTheInertialUnitReadsWrong) {
  const WholeDiagnosis diagnosis = diagnose(
      record({{"imu_misalignment", {{"x", 0}, {"y", 0.06}, {"z", 0}}, {}, ""}}, 1, 4, "squat"),
      kInertialUnit);
  EXPECT_EQ(placesOf(diagnosis), "imu_misalignment.y at robot; ");
  // How the robot came to stand, of which a log says nothing, tilts its torso by a third of a
  // degree.
  EXPECT_NEAR(diagnosis.set.joints.front().named()[0]->numbers[0].deviation, 0.06, 0.008);
}

TEST(WholeDiagnosis, AnInertialUnitThatReadsRightIsNotBlamed) {
  for (const std::uint64_t seed : {4, 6, 7}) {
    EXPECT_EQ(placesOf(diagnose(record({}, 1, seed, "squat"), kInertialUnit)), "") << seed;
  }
}

// A log begins anywhere between two ticks of the robot's clock: by replays whose clock began with
// them a hold of 7.5 ms was told as angles that are reported late, and two causes more.
TEST(WholeDiagnosis, AClockThatTicksBesideTheLogsBeginIsAHold) {
  const EffectSetting hold{"command_hold", {{"interval", 0.0075}, {"phase", 0.0025}}, {}, ""};
  const WholeDiagnosis diagnosis =
      diagnose(record({hold}, 1, 5), {"command_hold", "command_latency", "sensor_delay"});
  EXPECT_EQ(placesOf(diagnosis), "command_hold at robot; ");
  EXPECT_NEAR(diagnosis.set.joints[0].findings[0].numbers[0].deviation, 0.0075, 2e-4);
}

// This level would not try it by itself here; of what is not so, one would show and one would not.
TEST(WholeDiagnosis, WhatALowerLevelFoundCompetesAgain) {
  const WholeDiagnosis diagnosis =
      diagnose(record({weakShoulder()}, 1, 3), {"encoder_offset at LShoulderPitch"},
               {{"LShoulderPitch", "kp_error", {-0.3}, true},
                {"RShoulderPitch", "kp_error", {-0.8}, true},
                {"HeadYaw", "kp_error", {-0.1}, true}});
  EXPECT_EQ(placesOf(diagnosis), "kp_error at LShoulderPitch; ");
  ASSERT_EQ(diagnosis.handed_on.size(), 3u);
  EXPECT_EQ(diagnosis.handed_on[0].outcome, "found here too");
  EXPECT_NEAR(diagnosis.handed_on[0].now.deviation, -0.4, 0.04);  // a tenth, by three short runs
  EXPECT_EQ(diagnosis.handed_on[1].outcome.find("not found here"), 0u);
  EXPECT_GT(diagnosis.handed_on[1].would_show, 2 * diagnosis.handed_on[2].would_show);
  EXPECT_EQ(diagnosis.handed_on[2].outcome, "these motions do not tell")
      << diagnosis.handed_on[2].would_show << " SD, threshold " << diagnosis.set.critical_gain;
  const auto json =
      nlohmann::json::parse(toJson(diagnosis, {"set", "nao_h21_v33", "command", "robot"}));
  EXPECT_EQ(json["handed_on"].size(), 3u);
}

// A heavy left leg, recorded by steps of 0.25 ms.
LogSet heavyLeg(const std::vector<std::string>& legs) {
  const auto robot = std::make_shared<RobotModel>(suspend(*test::robot("nao_h21_v33")));
  RecordingPlan plan;
  for (const std::string& leg : legs) {
    for (const std::string& name : robot->groups.at(leg)) {
      plan.joints.push_back(robot->actuators[index(*robot->findJoint(name))].name);
    }
  }
  std::vector<Joint> left;
  for (const std::string& name : robot->groups.at("LLeg")) left.push_back(*robot->findJoint(name));
  plan.model = robot;
  plan.motions = {standardRecording(robot)[1]};
  plan.motions[0].duration = 2;
  moveOnly(plan.joints, robot, plan.motions);
  plan.repeats = 3;
  plan.extra = robot->noise;
  plan.extra.push_back({"link_mass", {{"part", 0.3}}, left, ""});
  return recordSimulated(plan);
}

WholeDiagnosis diagnoseLimbs(const LogSet& set, std::vector<std::string> only) {
  WholeDiagnosisOptions options;
  options.level = Level::Limb;
  options.only = std::move(only);
  options.effort.base_runs = options.effort.step_runs = 12;
  options.effort.fit_runs = 3;
  options.effort.finalists = 3;
  return diagnoseWhole(set, test::robot("nao_h21_v33"), options);
}

Verdict verdictAt(const WholeDiagnosis& found, const std::string& place) {
  for (const JointVerdict& one : found.set.joints) {
    if (one.joint == place) return one.verdict;
  }
  return Verdict::Unfinished;
}

// By steps of 2 ms replays are off by more than noise: a gain of the other leg's hip was named,
// too, and something unknown in both.
TEST(WholeDiagnosis, ALegInWhichNothingIsWrongIsNotBlamed) {
  const WholeDiagnosis found = diagnoseLimbs(
      heavyLeg({"LLeg", "RLeg"}),
      {"link_mass", "kp_error at LHipPitch", "kp_error at RHipPitch", "kp_error at RHipRoll"});
  EXPECT_EQ(placesOf(found), "link_mass at LLeg; ");
  EXPECT_EQ(verdictAt(found, "RLeg"), Verdict::NoDiscrepancy);
}

// Of the right leg nothing was recorded but the motor that both share, and it is not searched. The
// right one was blamed as it stood elsewhere in replays.
TEST(WholeDiagnosis, AMotorThatTwoLegsShareIsExplainedOnce) {
  const WholeDiagnosis found =
      diagnoseLimbs(heavyLeg({"LLeg"}), {"link_mass", "kp_error at LHipYawPitch"});
  EXPECT_EQ(placesOf(found), "link_mass at LLeg; ");
  const std::vector<Rejected>& rejected = found.set.joints.front().rejected;
  const auto right = std::find_if(rejected.begin(), rejected.end(),
                                  [](const Rejected& one) { return one.cause == "RLeg"; });
  ASSERT_NE(right, rejected.end());
  EXPECT_EQ(right->reason.find("not searched"), 0u);
}

TEST(WholeSpread, TellsThatRepeatsScatterMoreThanTheModel) {
  const WholeSimulator simulator(record({}, 3, 1), test::robot("nao_h21_v33"));
  const WholeData data(simulator, simulator.joints(), false);
  const WholeSpread spread = fitSpread(data, {}, 12, 1);
  EXPECT_TRUE(spread.differs);
  EXPECT_NEAR(spread.noise.torque, 3, 0.7);
}

}  // namespace
}  // namespace nao::validation
