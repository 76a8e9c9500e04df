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

// Joint zeros of these two once let the sway grow with every step.
TEST(WalkExperiment, GoesStraightOnWithAnyJointZeros) {
  const Experiment& experiment = find("walk");
  for (const std::uint64_t seed : {7, 20}) {
    ExperimentSettings settings = onceWithoutChance(experiment);
    settings.seed = seed;
    const Report report = experiment.run(settings).report;
    EXPECT_NEAR(figure(report, "forward_distance_m"), 0.48, 0.05 * 0.48) << "seed " << seed;
    EXPECT_LE(figure(report, "lateral_drift_m"), 0.03) << "seed " << seed;
    EXPECT_LE(figure(report, "heading_error_deg"), 3) << "seed " << seed;
  }
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

const std::vector<Row>& rows(const Report& report) {
  for (const Figure& figure : report.figures) {
    if (figure.name == "rows") return std::get<std::vector<Row>>(figure.value);
  }
  throw std::runtime_error("no rows");
}

TEST(CircleExperiment, ComesRoundAndFitsTheRadiusItWalked) {
  const Report report = reportOf("circle");
  EXPECT_EQ(figure(report, "closed"), 1);
  EXPECT_LT(figure(report, "closure_error_m"), 0.20);  // the bar
  // Without chance the robot walks as odometry says, give or take the bar on odometry.
  const double odometry = figure(report, "odometry_radius_m");
  EXPECT_NEAR(figure(report, "radius_m"), odometry, 0.05 * odometry);
}

TEST(MoveToExperiment, ArrivesByOdometry) {
  const Experiment& experiment = find("moveto");
  ExperimentSettings settings = onceWithoutChance(experiment);
  settings.runs = 3;
  const Report report = experiment.run(settings).report;
  EXPECT_EQ(figure(report, "targets"), 3);
  EXPECT_EQ(figure(report, "falls"), 0);
  EXPECT_LE(figure(report, "arrival_error_m"), 0.01);      // the bar
  EXPECT_LE(figure(report, "arrival_error_deg"), 1);       // the bar
  EXPECT_LE(figure(report, "odometry_error_percent"), 5);  // the bar
}

TEST(PushExperiment, SeesThatNearlyTheWeightFellsTheRobotInEveryPhase) {
  const Experiment& experiment = find("push");
  ExperimentSettings settings = onceWithoutChance(experiment);
  settings.newton = 40;
  const Report report = experiment.run(settings).report;
  for (const char* side : {"front", "back", "left", "right"}) {
    EXPECT_EQ(figure(report, std::string("falls_") + side), 2 * 16) << side;
  }
}

TEST(RandomWalkExperiment, WalksTheMetresAskedFor) {
  const Experiment& experiment = find("randomwalk");
  ExperimentSettings settings = onceWithoutChance(experiment);
  settings.duration = std::chrono::seconds(2);
  settings.metres = 2;
  const Report report = experiment.run(settings).report;
  EXPECT_EQ(figure(report, "sequences"), 1);
  EXPECT_GE(figure(report, "straight_on_m"), 2);
  EXPECT_EQ(figure(report, "straight_on_falls"), 0);
}

TEST(FastWalkExperiment, MeasuresEveryWayAlongIt) {
  const Experiment& experiment = find("fastwalk");
  ExperimentSettings settings = onceWithoutChance(experiment);
  settings.duration = std::chrono::seconds(4);
  const Report report = experiment.run(settings).report;
  for (const Row& row : rows(report)) {
    const auto& way = std::get<std::string>(row[0].second);
    const double speed = std::get<double>(row[1].second);
    EXPECT_GT(speed, 0.05) << way;  // sideways 0.06 m/s, the others are faster
    EXPECT_NEAR(speed, std::get<double>(row[3].second), 0.15 * speed) << way;  // odometry
  }
}

TEST(SlopeExperiment, HasARowForEverySlopeFrictionAndMass) {
  const Experiment& experiment = find("slope");
  ExperimentSettings settings = onceWithoutChance(experiment);
  settings.duration = std::chrono::seconds(1);
  const Report report = experiment.run(settings).report;
  EXPECT_EQ(rows(report).size(), 13u + 12 + 9 + 2);
  EXPECT_GE(figure(report, "max_slope_deg"), 3);  // the bar, though on a short walk
}

}  // namespace
}  // namespace nao::validation
