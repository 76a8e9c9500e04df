#include "validation/diagnosis/replay/whole_simulator.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/support/models.h"
#include "validation/diagnosis/replay/gait_numbers.h"
#include "validation/diagnosis/whole/whole_features.h"
#include "validation/log/floor_recording.h"
#include "validation/log/standard_motions.h"

namespace nao::validation {
namespace {

LogSet record(const FloorMotion& motion, int repeats = 1,
              const std::vector<EffectSetting>& extra = {}) {
  FloorPlan plan;
  plan.model = test::robot("nao_h21_v33");
  plan.motions = {motion};
  plan.repeats = repeats;
  plan.extra = extra;
  return recordOnFloor(plan);
}

const FloorMotion kSquat{"squat", Split::Fit, 3, {}};
const FloorMotion kWalk{"walk_forward", Split::Fit, 4, Pose2{0.16, 0, 0}};

double numberOf(const WholeRun& run, const std::string& name) {
  for (const GaitNumber& number : calcGait(run)) {
    if (number.name == name) return number.value;
  }
  ADD_FAILURE() << "no " << name;
  return 0;
}

TEST(WholeSimulator, StandsAndBendsAsTheRecordedRobotDid) {
  const WholeSimulator simulator(record(kSquat), test::robot("nao_h21_v33"));
  const WholeRun replay = simulator.simulate({}, 0, 1, 0);
  const WholeRun& measured = simulator.measured()[0];
  ASSERT_EQ(replay.rows(), measured.rows());
  constexpr double kCounts = 0.003;  // [rad] two counts of the encoder, RMS
  for (const Joint joint : simulator.joints()) {
    const auto j = static_cast<Eigen::Index>(index(joint));
    const Eigen::VectorXd off = replay.angle.col(j) - measured.angle.col(j);
    const double rms = off.norm() / std::sqrt(static_cast<double>(off.size()));
    EXPECT_LT(rms, kCounts) << simulator.model().actuators[index(joint)].name;
  }
  EXPECT_FALSE(replay.fell);
}

TEST(WholeSimulator, WalksAsFarAsTheRecordedRobotThoughItsFeedbackIsInTheLogAlready) {
  const WholeSimulator simulator(record(kWalk), test::robot("nao_h21_v33"));
  const WholeRun replay = simulator.simulate({}, 0, 1, 1);
  const WholeRun& measured = simulator.measured()[0];
  EXPECT_GT(numberOf(measured, "ahead_m"), 0.13);
  EXPECT_NEAR(numberOf(replay, "ahead_m"), numberOf(measured, "ahead_m"), 0.02);
  EXPECT_NEAR(numberOf(replay, "turn_rad"), numberOf(measured, "turn_rad"), 0.1);
  EXPECT_NEAR(numberOf(replay, "pitch_sway_rad"), numberOf(measured, "pitch_sway_rad"), 0.006);
}

TEST(WholeSimulator, AStreamDrawsTheSameWhateverTheCausesAndAnotherDoesNot) {
  const WholeSimulator simulator(record({"arms", Split::Fit, 1, {}}), test::robot("nao_h21_v33"));
  const WholeRun one = simulator.simulate({}, 0, 1, 1);
  EXPECT_EQ(one.angle, simulator.simulate({}, 0, 1, 1).angle);
  EXPECT_NE(one.angle, simulator.simulate({}, 0, 2, 1).angle);
  // A cause on the head leaves the legs' noise as it was.
  const Joint head = *simulator.model().findJoint("HeadYaw");
  const EffectSetting offset{"encoder_offset", {{"angle", 0.05}}, {head}, ""};
  const auto knee = static_cast<Eigen::Index>(index(*simulator.model().findJoint("LKneePitch")));
  EXPECT_EQ(one.angle.col(knee), simulator.simulate({offset}, 0, 1, 1).angle.col(knee));
}

// [rad] RMS of all measured joints between a simulated run and the set's first.
double calcError(const LogSet& set) {
  const WholeSimulator simulator(set, test::robot("nao_h21_v33"));
  const WholeRun replay = simulator.simulate({}, 0, 1, 0);
  const Eigen::MatrixXd off = replay.angle - simulator.measured()[0].angle;
  return off.norm() / std::sqrt(static_cast<double>(off.size()));
}

TEST(WholeSimulator, CarriesTheLoadAndHasTheGainThatTheRunHad) {
  const auto model = test::robot("nao_h21_v33");
  const Joint elbow = *model->findJoint("LElbowRoll");
  const EffectSetting weight{"payload", {{"mass", 0.3}, {"x", 0.08}}, {elbow}, ""};
  LogSet loaded = record({"arms", Split::Fit, 2, {}}, 1, {weight});
  const double forgotten = calcError(loaded);
  for (std::size_t b = 1; b < model->bodies.size(); ++b) {
    if (model->coordinates[b - 1].joint != elbow) continue;
    loaded.runs[0].load = LogLoad{model->bodies[b].name, 0.3, {0.08, 0, 0}};
  }
  EXPECT_LT(calcError(loaded), 0.5 * forgotten);

  auto soft = std::make_shared<RobotModel>(*model);
  for (Actuator& actuator : soft->actuators) actuator.kp *= 0.3;
  FloorPlan plan;
  plan.model = soft;
  plan.motions = {{"arms", Split::Fit, 2, {}}};
  plan.repeats = 1;
  LogSet weak = recordOnFloor(plan);
  const double stiff = calcError(weak);
  weak.runs[0].kp_scale = 0.3;
  EXPECT_LT(calcError(weak), 0.5 * stiff);
}

TEST(WholeSimulator, RefusesALoadThatItCanNotCarry) {
  LogSet set = record({"arms", Split::Fit, 1, {}});
  for (const char* link : {"Tail", "base_link"}) {
    set.runs[0].load = LogLoad{link, 0.3, {0, 0, 0}};
    const WholeSimulator simulator(set, test::robot("nao_h21_v33"));
    EXPECT_THROW(simulator.simulate({}, 0, 1, 0), InputError) << link;
  }
}

TEST(WholeSimulator, LeavesTestRunsShutAndAsksForOneToFit) {
  LogSet set = record({"arms", Split::Fit, 1, {}}, 2);
  set.runs[1].split = Split::Test;
  EXPECT_EQ(WholeSimulator(set, test::robot("nao_h21_v33")).measured().size(), 1u);
  set.runs[0].split = Split::Test;
  EXPECT_THROW(WholeSimulator(set, test::robot("nao_h21_v33")), InputError);
}

TEST(WholeFeatures, GoAheadAddsUpInTheRobotsOwnFrame) {
  const WholeSimulator simulator(record(kWalk), test::robot("nao_h21_v33"));
  const FeatureSpace space(simulator, simulator.blocks()[0], simulator.joints(), true);
  const Eigen::VectorXd features = space.of(simulator.measured()[0]);
  double ahead = 0;
  for (const FeatureGroup& group : space.groups()) {
    if (group.name == "ahead") ahead = features.segment(group.offset, group.size).sum();
  }
  EXPECT_NEAR(ahead, numberOf(simulator.measured()[0], "ahead_m"), 0.02);
  EXPECT_GE(numberOf(simulator.measured()[0], "steps"), 3);
}

TEST(WholeSimulator, JointsThatNobodyMeasuredRestWhereTheMotionsOfTheRecordingBegin) {
  const auto robot = test::robot("nao_h21_v33");
  LogSet set;
  set.joints.resize(1);
  set.joints[0].name = "HeadYaw";
  LogRun run;
  run.t = {0, 0.01, 0.02};
  run.start_pose = kStandardRestPose;
  const WholeRun whole = wholeRunOf(run, set, *robot);
  const JointArray<double> rest = standardRest(*robot);
  const Joint roll = *robot->findJoint("RShoulderRoll");
  ASSERT_GT(std::abs(rest[roll]), 0.1);
  EXPECT_EQ(whole.command(2, static_cast<Eigen::Index>(index(roll))), rest[roll]);
}

TEST(WholeSimulator, APoseThatNobodyKnowsIsToldByItsRun) {
  LogSet set;
  LogRun run;
  run.file = "run_squat_0.csv";
  run.t = {0, 0.01, 0.02};
  run.start_pose = "Handstand";
  try {
    wholeRunOf(run, set, *test::robot("nao_h21_v33"));
    ADD_FAILURE() << "it was accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "start_pose of run_squat_0.csv: expected a posture of nao_h21_v33 or 'rest of the "
                 "standard motions', found 'Handstand'");
  }
}

}  // namespace
}  // namespace nao::validation
