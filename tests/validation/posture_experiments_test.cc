// The experiments about postures, one run of each without chance.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/experiment.h"
#include "validation/posture_trial.h"

namespace nao::validation {
namespace {

Report reportOf(const std::string& name) {
  for (const Experiment& experiment : experiments()) {
    if (experiment.name != name) continue;
    ExperimentSettings settings = experiment.defaults;
    settings.robots_dir = NAO_SOURCE_DIR "/robots";
    settings.seed = 0;
    settings.runs = 1;
    return experiment.run(settings).report;
  }
  throw std::runtime_error("no experiment " + name);
}

template <typename T>
const T& figure(const Report& report, const std::string& name) {
  for (const Figure& figure : report.figures) {
    if (figure.name == name) return std::get<T>(figure.value);
  }
  throw std::runtime_error("no figure " + name);
}

TEST(StandUpExperiment, CountsRobotsThatStandInTheEnd) {
  const Report report = reportOf("standup");
  EXPECT_EQ(figure<double>(report, "runs"), 1);
  EXPECT_EQ(figure<double>(report, "back_success"), 1);
  EXPECT_EQ(figure<double>(report, "front_success"), 1);
  EXPECT_LT(figure<Statistics>(report, "back_tilt_deg").max, 10);
  EXPECT_EQ(figure<std::vector<Row>>(report, "rows").size(), 4u);
}

TEST(PosturesExperiment, GoesFromEveryPostureToEveryOther) {
  const Report report = reportOf("postures");
  EXPECT_EQ(figure<double>(report, "pairs"), 8 * 7);
  EXPECT_EQ(figure<double>(report, "reached"), 8 * 7);
}

TEST(PostureTrial, BelievesNoRobotThatLies) {
  ExperimentSettings settings;
  settings.robots_dir = NAO_SOURCE_DIR "/robots";
  PostureTrial trial(settings, 0);
  EXPECT_TRUE(trial.isReallyIn("StandInit"));
  EXPECT_FALSE(trial.isReallyIn("Crouch"));
  trial.knockOver(-45, 0);
  EXPECT_FALSE(trial.isReallyIn("StandInit"));
  const Arrival arrival = trial.goTo("LyingBack");
  EXPECT_TRUE(arrival.there);
  EXPECT_GT(arrival.tilt_deg, 60);
}

}  // namespace
}  // namespace nao::validation
