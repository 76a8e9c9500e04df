// What is said of a recorded run, of another one beside it, and of the same on another start.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/check.h"
#include "runtime/recorder.h"
#include "tests/core/temporary_folder.h"
#include "tests/support/models.h"
#include "validation/recorded/run_difference.h"
#include "validation/recorded/run_log.h"
#include "validation/recorded/start_change.h"

namespace nao::validation {
namespace {

using runtime::Recording;
using runtime::Replayer;
using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

runtime::RunStart oneNao() {
  runtime::RunStart start;
  start.world = test::flatWorld();
  start.robots = {{"nao", test::robot("nao_h21_v33"), {}}};
  return start;
}

/// Three seconds of waking up, with a push of `force` [N] after two.
Recording record(const std::string& file, double force) {
  const runtime::RunStart start = oneNao();
  runtime::Simulation simulation = start.makeSimulation();
  runtime::Recorder recorder(file, start);
  simulation.watch(recorder);
  EXPECT_TRUE(simulation.robot(0).ports()->requests.post({1, motion::WakeUp{}}));
  simulation.advanceTo(SimTime(2s));
  simulation.apply(runtime::PushRobot{0, Vec3(force, 0, 0), 100ms});
  simulation.advanceTo(SimTime(3s));
  recorder.finish(simulation);
  return runtime::readRecording(file);
}

class RecordedRun : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const Recording run_ = record(folder_.path() + "/one.rec", 3);
};

TEST_F(RecordedRun, IsWrittenAsTheSensorsAndCommandsOfEveryCycle) {
  Replayer replayer(run_);
  const RunLog log(replayer, 0, {1s, 2s});
  std::vector<double> times;
  std::vector<double> knee;
  while (replayer.step()) {
    const auto sensors = replayer.simulation().robot(0).ports()->sensors.get();
    const double t = toSeconds(sensors->time);
    if (t < 1 || t > 2 || (!times.empty() && times.back() == t)) continue;
    times.push_back(t);
    knee.push_back(sensors->angle[*replayer.simulation().robot(0).model().findJoint("LKneePitch")]);
  }
  const LogSet set = log.set("test");
  ASSERT_EQ(set.runs.size(), 1u);
  EXPECT_EQ(set.robot, "nao_h21_v33");
  EXPECT_EQ(log.run().t, times);
  EXPECT_EQ(set.runs[0].t.front(), 0);  // of a set, from its begin
  EXPECT_NEAR(set.runs[0].t.back(), times.back() - times.front(), 1e-12);
  EXPECT_EQ(times.size(), 101u);
  EXPECT_EQ(set.runs[0].columns.at("q.LKneePitch"), knee);
  EXPECT_NEAR(set.runs[0].columns.at("gt.base.z").back(), 0.32, 0.05);  // it stands up
}

TEST_F(RecordedRun, IsASetThatIsReadAsAMeasuredOne) {
  Replayer replayer(run_);
  const RunLog log(replayer, 0, {});
  replayer.advanceTo(3s);
  const LogSet set = log.set("replayed");
  writeLogSet(set, folder_.path() + "/set");
  const LogSet read = readLogSet(folder_.path() + "/set");
  ASSERT_EQ(read.runs.size(), 1u);
  EXPECT_EQ(read.source, "replayed");
  EXPECT_EQ(read.runs[0].t, set.runs[0].t);
  EXPECT_EQ(read.runs[0].columns, set.runs[0].columns);
  EXPECT_EQ(read.joints.size(), set.joints.size());
}

TEST_F(RecordedRun, IsNoDifferentFromItself) {
  Replayer one(run_);
  Replayer other(run_);
  EXPECT_FALSE(findDifference(one, other));
  EXPECT_EQ(one.elapsed(), 3s);
  EXPECT_EQ(describeInputDifference(run_, run_), "");
}

TEST_F(RecordedRun, PartsFromAnotherAtTheStepOfItsOtherInput) {
  const Recording harder = record(folder_.path() + "/two.rec", 4);
  Replayer one(run_);
  Replayer other(harder);
  const auto difference = findDifference(one, other);
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference->elapsed, 2002ms);
  EXPECT_GT(difference->at_once.place, 0);
  EXPECT_LT(difference->at_once.place, 1e-5);  // 1 N for 2 ms moves 5 kg by 0.4 um, a link by more
  EXPECT_EQ(difference->at_once.command, 0);   // nobody has felt it yet
  EXPECT_EQ(difference->later_at, 3s);
  EXPECT_GT(difference->later.place, difference->at_once.place);
  EXPECT_EQ(describeInputDifference(run_, harder),
            "input 2: PushRobot at 2.000 s has other values there");
}

TEST_F(RecordedRun, NamesTheJointThatDiffersAndByHowMuch) {
  runtime::RunStart start = run_.start;
  auto robot = std::make_shared<RobotModel>(*start.robots[0].model);
  const Joint elbow = *robot->findJoint("LElbowRoll");
  constexpr double kOffset = 0.1;  // [rad] that the servo believes, once it is stiff
  robot->effects.push_back({"encoder_offset", {{"angle", kOffset}}, {elbow}, "test"});
  start.robots[0].model = robot;
  Replayer one(run_);
  Replayer other(run_, start);
  EXPECT_TRUE(findDifference(one, other));
  one.advanceTo(3s);
  other.advanceTo(3s);
  const Apart apart = calcApart(one.simulation(), other.simulation());
  EXPECT_EQ(apart.hinge, "nao.LElbowRoll");
  EXPECT_NEAR(apart.angle, kOffset, 0.02);  // an elbow's play, 0.0175 rad
}

TEST_F(RecordedRun, OfOtherRobotsIsRefused) {
  runtime::RunStart start = run_.start;
  start.robots.push_back({"other", test::robot("nao_h21_v33"), {0, 1, 0}});
  Replayer one(run_);
  Replayer other(run_, start);
  EXPECT_THROW(findDifference(one, other), InputError);
}

std::vector<double> widths(const RobotModel& robot) {
  std::vector<double> widths;
  for (const EffectSetting& effect : robot.effects) {
    if (effect.name == "backlash") widths.push_back(effect.parameters.at("width"));
  }
  return widths;
}

TEST(StartChange, ChangesAnEffectWhereverItActs) {
  runtime::RunStart start = oneNao();
  const auto before = start.robots[0].model;
  ASSERT_EQ(widths(*before).size(), 2u);
  changeStart("robot.effects.backlash=0.01", start);
  EXPECT_EQ(widths(*start.robots[0].model), (std::vector<double>{0.01, 0.01}));
  changeStart("nao.effects.backlash.width=0.02", start);
  EXPECT_EQ(widths(*start.robots[0].model), (std::vector<double>{0.02, 0.02}));
  changeStart("robot.effects.backlash=off", start);
  EXPECT_TRUE(widths(*start.robots[0].model).empty());
  EXPECT_EQ(widths(*before).size(), 2u);  // others keep theirs
}

TEST(StartChange, AddsAnEffectThatTheRobotHasNot) {
  runtime::RunStart start = oneNao();
  changeStart("robot.effects.process_noise.sd=0.5", start);
  const EffectSetting& added = start.robots[0].model->effects.back();
  EXPECT_EQ(added.name, "process_noise");
  EXPECT_EQ(added.parameters.at("sd"), 0.5);
}

TEST(StartChange, ChangesFloorAndSeed) {
  runtime::RunStart start = oneNao();
  changeStart("world.friction=0.25", start);
  changeStart("seed=42", start);
  EXPECT_EQ(start.world->ground.friction, 0.25);
  EXPECT_EQ(start.seed, 42u);
}

TEST(StartChange, SaysWhatThereIsWhenItIsWrong) {
  const auto complaint = [](const std::string& setting) -> std::string {
    runtime::RunStart start = oneNao();
    try {
      changeStart(setting, start);
    } catch (const InputError& error) {
      return error.what();
    }
    return "none";
  };
  EXPECT_EQ(complaint("bert.effects.backlash=0"),
            "--set bert.effects.backlash=0: expected `robot` or one of the robots nao");
  EXPECT_THAT(complaint("robot.effects.magic=1"), testing::HasSubstr(", backlash, "));
  EXPECT_EQ(
      complaint("robot.effects.backlash.depth=1"),
      "--set robot.effects.backlash.depth=1: expected one of the parameters width, compliance");
  EXPECT_EQ(complaint("robot.effects.backlash=0.01"), "none");  // its width: the flanks stay hard
  for (const char* wrong : {"", "seed", "seed=x", "seed=-1", "robot=1", "world.mass=2"}) {
    EXPECT_THAT(complaint(wrong), testing::HasSubstr("expected ROBOT.effects.EFFECT")) << wrong;
  }
}

}  // namespace
}  // namespace nao::validation
