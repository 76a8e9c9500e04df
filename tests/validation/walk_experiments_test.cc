// The walk's experiments, few and short runs of them, without chance.
#include <gtest/gtest.h>

#include <cmath>

#include "validation/experiment.h"

namespace nao::validation {
namespace {

const Experiment& find(const std::string& name) {
  for (const Experiment& experiment : experiments()) {
    if (experiment.name == name) return experiment;
  }
  throw std::runtime_error("no experiment " + name);
}

ExperimentSettings onceWithoutChance(const Experiment& experiment) {
  ExperimentSettings settings = experiment.defaults;
  settings.robots_dir = NAO_SOURCE_DIR "/robots";
  settings.seed = 0;
  settings.runs = 1;
  return settings;
}

double figure(const Report& report, const std::string& name) {
  for (const Figure& figure : report.figures) {
    if (figure.name != name) continue;
    if (const auto* statistics = std::get_if<Statistics>(&figure.value)) return statistics->mean;
    return std::get<double>(figure.value);
  }
  ADD_FAILURE() << "no figure " << name;
  return std::nan("");
}

Report reportOf(const std::string& name) {
  const Experiment& experiment = find(name);
  return experiment.run(onceWithoutChance(experiment)).report;
}

TEST(WalkExperiment, GoesTwelveStepsStraightOn) {
  const Report report = reportOf("walk");
  EXPECT_NEAR(figure(report, "odometry_distance_m"), 12 * 0.04, 1e-9);   // exactly twelve steps
  EXPECT_NEAR(figure(report, "forward_distance_m"), 0.48, 0.05 * 0.48);  // the bar
  EXPECT_LE(figure(report, "lateral_drift_m"), 0.03);                    // the bar
  EXPECT_LE(figure(report, "heading_error_deg"), 3);                     // the bar
  EXPECT_EQ(figure(report, "falls"), 0);
}

TEST(TurnExperiment, TurnsTwelveStepsBothWays) {
  const Report report = reportOf("turn");
  EXPECT_NEAR(figure(report, "turn_left_deg"), 210, 0.05 * 210);   // the bar
  EXPECT_NEAR(figure(report, "turn_right_deg"), 210, 0.05 * 210);  // the bar
  EXPECT_EQ(figure(report, "falls"), 0);
}

TEST(WalkExperiment, IsTheSameForTheSameSeed) {
  const Experiment& experiment = find("walk");
  ExperimentSettings settings = onceWithoutChance(experiment);
  settings.seed = 5;
  const Report first = experiment.run(settings).report;
  EXPECT_EQ(first.hash, experiment.run(settings).report.hash);
  settings.seed = 6;
  EXPECT_NE(first.hash, experiment.run(settings).report.hash);
}

}  // namespace
}  // namespace nao::validation
