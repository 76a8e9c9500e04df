// Small, fast versions of the experiments; they assert the bars of the full ones.
#include "validation/experiment.h"

#include <gtest/gtest.h>

#include <cmath>

#include "validation/block.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""s;

const Experiment& find(const std::string& name) {
  for (const Experiment& experiment : experiments()) {
    if (experiment.name == name) return experiment;
  }
  throw std::runtime_error("no experiment " + name);
}

ExperimentSettings settingsOf(const Experiment& experiment) {
  ExperimentSettings settings = experiment.defaults;
  settings.robots_dir = NAO_SOURCE_DIR "/robots";
  return settings;
}

double number(const Report& report, const std::string& name) {
  for (const Figure& figure : report.figures) {
    if (figure.name == name) return std::get<double>(figure.value);
  }
  ADD_FAILURE() << "no figure " << name;
  return std::nan("");
}

const std::vector<Row>& rows(const Report& report) {
  for (const Figure& figure : report.figures) {
    if (figure.name == "rows") return std::get<std::vector<Row>>(figure.value);
  }
  throw std::runtime_error("no rows");
}

TEST(BlockStack, RestsWhereTorqueAndStiffnessBalance) {
  const BlockStack stack;
  const double command = 0.5;
  const double angle = stack.restAngle(command, 9.81);
  const double weight_torque = 3 * stack.mass * 9.81 * 1.5 * stack.edge * std::sin(angle);
  EXPECT_NEAR(stack.kp * (angle - command), weight_torque, 1e-12);
  EXPECT_GT(angle, command);
}

TEST(TimestepExperiment, SagIsTheAnalyticOneAtEveryStep) {
  const Experiment& experiment = find("timestep");
  const Report report = experiment.run(settingsOf(experiment)).report;
  EXPECT_LE(number(report, "sag_error_max_deg"), 0.001);  // the bar
  EXPECT_GT(number(report, "analytic_sag_deg"), 0.1);     // there is a sag to be seen
  ASSERT_EQ(rows(report).size(), 20u);
  EXPECT_DOUBLE_EQ(std::get<double>(rows(report).front()[0].second), 1.0 / 20);
  EXPECT_DOUBLE_EQ(std::get<double>(rows(report).back()[0].second), 1.0 / 1000);
}

TEST(ThrashExperiment, DoesNotBlowUp) {
  const Experiment& experiment = find("thrash");
  ExperimentSettings settings = settingsOf(experiment);
  settings.runs = 2;
  settings.duration = 3s;
  const Report report = experiment.run(settings).report;
  EXPECT_EQ(number(report, "blowups"), 0);
  EXPECT_EQ(number(report, "runs"), 2);
  ASSERT_EQ(rows(report).size(), 3u);  // 1, 2 and 5 ms
}

TEST(ThrashExperiment, IsTheSameForTheSameSeedAlone) {
  const Experiment& experiment = find("thrash");
  ExperimentSettings settings = settingsOf(experiment);
  settings.runs = 1;
  settings.duration = 1s;
  const std::uint64_t hash = experiment.run(settings).report.hash;
  EXPECT_EQ(experiment.run(settings).report.hash, hash);
  settings.seed = 2;
  EXPECT_NE(experiment.run(settings).report.hash, hash);
}

TEST(Experiments, NameARobotThatDoesNotExist) {
  for (const Experiment& experiment : experiments()) {
    if (!experiment.heeds(Choice::Robot)) continue;
    ExperimentSettings settings = settingsOf(experiment);
    settings.robot = "nao_h99";
    EXPECT_THROW(experiment.run(settings), InputError) << experiment.name;
  }
}

}  // namespace
}  // namespace nao::validation
