#include "tests/hidden/hidden_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "sim/effects/catalogue.h"
#include "tests/hidden/preset.h"
#include "tests/support/models.h"
#include "validation/log/data_faults.h"

namespace nao::hidden {
namespace {

HiddenCase friction(double size) {
  HiddenCase hidden;
  hidden.kind = Kind::WeakSingle;  // looks for no look-alikes
  hidden.seed = 7;
  hidden.joints = {"HeadYaw"};
  hidden.repeats = 2;
  hidden.limbs = true;
  hidden.wishes = {{likenessHideouts().front(), size}};
  return hidden;
}

TEST(HiddenSet, IsTheSameForTheSameCaseAndSaysNothingOfWhatItHides) {
  const auto model = test::robot("nao_h21_v33");
  const HiddenSet one = makeHiddenSet(friction(8), model);
  const HiddenSet two = makeHiddenSet(friction(8), model);
  ASSERT_EQ(one.set.runs.size(), 14u);
  EXPECT_EQ(one.set.runs[3].columns, two.set.runs[3].columns);
  EXPECT_EQ(one.set.name, friction(8).name());
  EXPECT_EQ(one.set.source, "simulated");
  EXPECT_TRUE(one.set.runs[0].notes.empty());
}

TEST(HiddenSet, EffectsComeOutAsLargeAsWished) {
  const auto model = test::robot("nao_h21_v33");
  for (const double size : {6.0, 14.0}) {
    const Truth truth = chooseHidden(friction(size), model);
    ASSERT_EQ(truth.hidden.size(), 1u);
    EXPECT_TRUE(truth.shortfall.empty());
    EXPECT_NEAR(truth.hidden[0].size, size, 0.3 * size);
    EXPECT_GT(truth.hidden[0].deviation, 0);
  }
}

// A head that turns carries no weight: to follow less is to be late.
TEST(HiddenSet, LooksAlikesAreListedBeforehandAndOthersAreNot) {
  HiddenCase hidden = friction(8);
  hidden.kind = Kind::Single;
  for (const Hideout& hideout : catalogueHideouts()) {
    if (hideout.cause == "kp_error" && hideout.start < 0) hidden.wishes = {{hideout, 8}};
  }
  const Truth truth = chooseHidden(hidden, test::robot("nao_h21_v33"));
  ASSERT_EQ(truth.hidden.size(), 1u);
  const std::vector<std::string>& alike = truth.hidden[0].look_alikes;
  const auto listed = [&](const char* cause) {
    return std::find(alike.begin(), alike.end(), cause) != alike.end();
  };
  EXPECT_TRUE(listed("sensor_delay") || listed("command_latency"));
  EXPECT_FALSE(listed("backlash"));
  EXPECT_FALSE(listed("kp_error"));
}

// It turns about the vertical: its zero shows nowhere but where it meets its stop that much
// earlier.
TEST(HiddenSet, AZeroThatMeetsAStopLooksLikeAStopThatWasMoved) {
  HiddenCase hidden = friction(8);
  hidden.kind = Kind::Single;
  for (const Hideout& hideout : catalogueHideouts()) {
    if (hideout.cause == "encoder_offset" && hideout.start < 0) hidden.wishes = {{hideout, 8}};
  }
  const Truth truth = chooseHidden(hidden, test::robot("nao_h21_v33"));
  ASSERT_TRUE(truth.shortfall.empty()) << truth.shortfall;
  const std::vector<std::string>& alike = truth.hidden.at(0).look_alikes;
  EXPECT_NE(std::find(alike.begin(), alike.end(), "joint_stop.upper"), alike.end());
  EXPECT_EQ(std::find(alike.begin(), alike.end(), "joint_stop.lower"), alike.end());
}

TEST(Hideout, HidesNothingBesideItsNumber) {
  const auto model = test::robot("nao_h21_v33");
  for (const Hideout& hideout : catalogueHideouts()) {
    const EffectSetting setting = settingAt(hideout, hideout.start, *model, "LAnkleRoll");
    for (const sim::Parameter& parameter : sim::standardEffects().find(hideout.law)->parameters) {
      if (parameter.name == hideout.parameter || hideout.shape.count(parameter.name) > 0) continue;
      ASSERT_EQ(setting.parameters.count(parameter.name), 1u) << hideout.cause;
      EXPECT_EQ(setting.parameters.at(parameter.name), parameter.neutral) << hideout.cause;
    }
  }
}

TEST(HiddenSet, RobotsDifferUndeclared) {
  RobotModel robot = *test::robot("nao_h21_v33");
  const RobotModel nominal = robot;
  addUndeclaredDifferences(robot, 3);
  for (std::size_t j = 0; j < robot.jointCount(); ++j) {
    const double ratio = robot.actuators[j].kp / nominal.actuators[j].kp;
    EXPECT_NE(ratio, 1);
    EXPECT_NEAR(ratio, 1, 0.02);
  }
  EXPECT_GT(robot.effects.size(), nominal.effects.size());
}

TEST(Preset, TakesAThirdOfItsSinglesFromOtherLawsAndShuffles) {
  const std::vector<HiddenCase> cases = makeCases(countsOf("standard"), 5);
  int singles = 0, own = 0;
  bool sorted = true;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    sorted = sorted && (i == 0 || cases[i - 1].kind <= cases[i].kind);
    if (cases[i].kind != Kind::Single) continue;
    ++singles;
    own += cases[i].wishes.front().hideout.law.rfind("hidden_", 0) == 0;
  }
  EXPECT_EQ(cases.size(), 300u);
  EXPECT_FALSE(sorted);
  EXPECT_GT(3 * own, singles);
}

TEST(Preset, HoldsSetsOfEveryLevel) {
  for (const char* preset : {"quick", "standard", "full"}) {
    std::map<std::string, int> sets;
    for (const HiddenCase& one : makeCases(countsOf(preset), 5)) ++sets[one.level];
    EXPECT_GE(sets["joint"], 10) << preset;
    EXPECT_GE(sets["limb"], 1) << preset;
    EXPECT_GE(sets["robot"], 1) << preset;
  }
}

TEST(FloorSet, IsOfOneMotionAndItsLastRunsAreHeldBack) {
  HiddenCase hidden;
  hidden.kind = Kind::NearNull;
  hidden.scene = Scene::Walk;
  hidden.repeats = 5;
  const auto model = test::robot("nao_h21_v33");
  const HiddenSet made = makeHiddenSet(hidden, model);
  ASSERT_EQ(made.set.runs.size(), 5u);
  EXPECT_EQ(made.set.runs[2].split, validation::Split::Fit);
  EXPECT_EQ(made.set.runs[3].split, validation::Split::Select);
  EXPECT_EQ(made.set.runs[4].split, validation::Split::Test);
  EXPECT_EQ(made.set.name, hidden.name());
  EXPECT_FALSE(made.truth.fell);
  const validation::Column& x = made.set.runs[0].columns.at("gt.base.x");
  EXPECT_NEAR(x.back() - x.front(), 0.4, 0.05);  // 0.095 m/s, less the first steps
  EXPECT_NE(x, made.set.runs[1].columns.at("gt.base.x"));
}

// Where a motion's runs have different splits, check-data calls it a fault, and nobody diagnoses
// it.
TEST(FloorSet, OfSeveralMotionsIsSplitByThem) {
  HiddenCase hidden;
  hidden.kind = Kind::NearNull;
  hidden.scene = Scene::Stand;
  hidden.repeats = 2;
  const auto model = test::robot("nao_h21_v33");
  const validation::LogSet set = makeHiddenSet(hidden, model).set;
  std::set<validation::Split> splits;
  for (const validation::LogRun& run : set.runs) splits.insert(run.split);
  EXPECT_EQ(splits.size(), 3u);
  for (const validation::DataFault& fault : validation::findDataFaults(set, model.get())) {
    EXPECT_TRUE(fault.note) << fault.sentence;
  }
}

TEST(Preset, KnowsTenCausesThatNoCatalogueHas) { EXPECT_GE(strangerHideouts().size(), 10u); }

}  // namespace
}  // namespace nao::hidden
