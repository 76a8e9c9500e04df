#include "validation/diagnosis/replay/whole_replay.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/models.h"
#include "validation/diagnosis/extend/gain.h"
#include "validation/diagnosis/extend/replay_set.h"
#include "validation/log/floor_recording.h"

namespace nao::validation {
namespace {

EffectSetting late() { return {"command_latency", {{"delay", 0.04}}, {}, ""}; }

// Squats of a robot that hears late, or of one like the model; the last repeats are for test.
LogSet squats(int repeats, const std::vector<EffectSetting>& extra = {late()}) {
  FloorPlan plan;
  plan.model = test::robot("nao_h21_v33");
  plan.motions = {{"squat", Split::Fit, 3, {}}};
  plan.repeats = repeats;
  plan.extra = extra;
  LogSet set = recordOnFloor(plan);
  set.name = "squats";
  for (std::size_t i = set.runs.size() / 2; i < set.runs.size(); ++i) {
    set.runs[i].split = Split::Test;
  }
  return set;
}

double meanMisfit(const WholeReplay& replay) {
  double sum = 0;
  for (const JointReplay& joint : replay.joints) sum += joint.misfit;
  return sum / static_cast<double>(replay.joints.size());
}

double figure(const Report& report, const std::string& name) {
  for (const Figure& one : report.figures) {
    if (one.name == name) return std::get<double>(one.value);
  }
  ADD_FAILURE() << "no " << name;
  return 0;
}

// A log does not tell how a robot came to stand as it does, so that not even runs of the model
// itself are replayed to the noise: that is what a model with the cause comes down to.
TEST(WholeReplay, IsNoFurtherOffThanOfTheModelsOwnRunsOnceItHasTheCause) {
  const auto model = test::robot("nao_h21_v33");
  const WholeSimulator with(squats(6), model), without(squats(6, {}), model);
  const double own = meanMisfit(replayWhole(without, {}, 4, 2));
  const WholeReplay extended = replayWhole(with, {late()}, 4, 2);
  EXPECT_GT(meanMisfit(replayWhole(with, {}, 4, 2)), 2.5 * own);  // the size of the effect
  EXPECT_LT(meanMisfit(extended), 1.3 * own);                     // chance in three runs of either
  EXPECT_EQ(extended.runs, 12);
  EXPECT_EQ(extended.fell, 0);
}

TEST(WholeReplay, IsTheSameForAnyNumberOfThreads) {
  const WholeSimulator simulator(squats(2), test::robot("nao_h21_v33"));
  const WholeReplay one = replayWhole(simulator, {}, 2, 1), two = replayWhole(simulator, {}, 2, 2);
  for (std::size_t i = 0; i < one.joints.size(); ++i) {
    EXPECT_EQ(one.joints[i].rmse, two.joints[i].rmse);
    EXPECT_EQ(one.joints[i].misfit, two.joints[i].misfit);
  }
}

TEST(Gain, OfARobotOnItsFeetIsMeasuredOnItsTestRunsWithItsGait) {
  const LogSet set = squats(6);
  const auto nominal = test::robot("nao_h21_v33");
  const auto extended = std::make_shared<RobotModel>(*nominal);
  extended->effects.push_back(late());
  const Report report = measureGain(set, nominal, extended, 1, {12, 2});
  const auto excess = [&](const std::string& name) {
    return std::pow(figure(report, name), 2) - std::pow(figure(report, "floor_rmse"), 2);
  };
  EXPECT_LT(excess("after_rmse"), 0.1 * excess("before_rmse"));
  EXPECT_EQ(report.tables.size(), 2u);
  EXPECT_EQ(report.tables[1].title, "Test runs: mean of the gait");
  const auto tellsWorse = [](const Report& one) {
    return std::any_of(one.remarks.begin(), one.remarks.end(), [](const std::string& remark) {
      return remark.rfind("Worse than before: ", 0) == 0;
    });
  };
  EXPECT_TRUE(tellsWorse(measureGain(set, extended, nominal, 2, {12, 2})));
}

TEST(Replay, OfARobotOnItsFeetLeavesTestRunsShut) {
  LogSet set = squats(4);
  const Report report = replaySet(set, test::robot("nao_h21_v33"), {4, 2});
  EXPECT_GT(figure(report, "misfit_max"), 3);
  for (LogRun& run : set.runs) {
    if (run.split == Split::Test) run.columns.at("q.HeadYaw").assign(run.t.size(), 1);
  }
  EXPECT_EQ(figure(replaySet(set, test::robot("nao_h21_v33"), {4, 2}), "misfit_max"),
            figure(report, "misfit_max"));
}

}  // namespace
}  // namespace nao::validation
