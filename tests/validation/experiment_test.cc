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
  settings.motions_dir = NAO_SOURCE_DIR "/motions";
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

TEST(GravityExperiment, CorrectionIsOneInTheThesisTable) {
  const Experiment& experiment = find("gravity");
  const Report report = experiment.run(settingsOf(experiment)).report;
  EXPECT_LE(number(report, "correction_max_error"), 1e-6);         // the bar
  EXPECT_LE(number(report, "damped_correction_max_error"), 1e-6);  // the bar
  // First order: the error follows the step, but for its own square (0.5 %).
  const double at_1ms = number(report, "implicit_error_1ms");
  EXPECT_NEAR(number(report, "implicit_error_2ms") / at_1ms, 2, 0.01);
  EXPECT_NEAR(number(report, "implicit_error_5ms") / at_1ms, 5, 0.03);

  ASSERT_EQ(rows(report).size(), 2 * 4 + 3u);  // two modes, then three implicit steps
  for (const Row& row : rows(report)) {
    for (const auto& [name, cell] : row) {
      const auto* numbers = std::get_if<std::vector<double>>(&cell);
      if (name.find("correction") == std::string::npos) continue;
      ASSERT_NE(numbers, nullptr);
      EXPECT_EQ(numbers->size(), 6u);
    }
  }
  // 9.81 / 4.16, what the default gravity of Unreal is short of.
  const auto& second = std::get<std::vector<double>>(rows(report)[1][5].second);
  for (const double correction : second) EXPECT_NEAR(correction, 9.81 / 4.16, 1e-6);
}

TEST(StandExperiment, StandsWhereItStands) {
  const Experiment& experiment = find("stand");
  ExperimentSettings settings = settingsOf(experiment);
  settings.duration = 10s;
  const Report report = experiment.run(settings).report;
  EXPECT_LE(number(report, "drift_m"), 1e-4);  // the bars, over 60 s there
  EXPECT_LE(number(report, "tilt_change_deg"), 0.05);
  EXPECT_LE(number(report, "penetration_max_m"), 1e-3);
  EXPECT_GT(number(report, "penetration_max_m"), 1e-5);  // it does stand on something
  EXPECT_EQ(number(report, "duration_s"), 10);
  ASSERT_EQ(rows(report).size(), 2u);  // ideal, and with its documented effects
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

TEST(HeadYawExperiment, NeitherFramesNorClientsChangeTheMotion) {
  const Experiment& experiment = find("headyaw");
  const Report report = experiment.run(settingsOf(experiment)).report;
  EXPECT_EQ(number(report, "max_deviation_deg"), 0);  // to the last bit
  ASSERT_EQ(rows(report).size(), 12u);                // six frame rates, two intervals
  for (const Row& row : rows(report)) EXPECT_EQ(std::get<double>(row[3].second), 1);
  EXPECT_GT(number(report, "command_to_sensor_shift_ms"), 0);
  EXPECT_LT(number(report, "command_to_sensor_shift_ms"), 50);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

// A hundred megabytes that are free again, but not the system's: what lies behind them is in use.
std::unique_ptr<std::string> leaveAGap() {
  std::vector<std::unique_ptr<std::string>> pieces;
  for (int i = 0; i < 100'000; ++i) pieces.push_back(std::make_unique<std::string>(1000, 'x'));
  return std::move(pieces.back());
}

TEST(RobotsExperiment, ShowsSpeedMemoryAndParts) {
  const auto behind = leaveAGap();  // as earlier tests do
  const Experiment& experiment = find("robots");
  ExperimentSettings settings = settingsOf(experiment);
  settings.duration = std::chrono::milliseconds(90);  // a cycle for each of nine parts
  const Outcome outcome = experiment.run(settings);
  const std::vector<Row>& loads = rows(outcome.report);
  ASSERT_EQ(loads.size(), 5u);
  const double robots[] = {1, 2, 4, 8, 22};
  for (std::size_t i = 0; i < loads.size(); ++i) {
    EXPECT_EQ(std::get<double>(loads[i][0].second), robots[i]);
    EXPECT_GT(std::get<double>(loads[i][1].second), 0);
    const double megabytes = std::get<double>(loads[i][3].second);
    EXPECT_GT(megabytes, 0);
    if (!kSanitized) {  // a sanitizer keeps what is freed
      EXPECT_LE(megabytes, 20) << "per robot, the bar";
    }
  }
  EXPECT_EQ(outcome.report.remarks.size(), 1u);  // nobody fell
  EXPECT_EQ(outcome.picture.panels.size(), 3u);
}

TEST(SonarExperiment, MeasuresToACentimetre) {
  const Experiment& experiment = find("sonar");
  ExperimentSettings settings = settingsOf(experiment);
  settings.duration = 1s;
  const Report report = experiment.run(settings).report;
  EXPECT_LE(number(report, "max_error_m"), 0.01);  // the bar
  EXPECT_EQ(number(report, "false_echoes"), 0);
  EXPECT_GT(number(report, "cpu_us_per_cycle_4_robots"), 0);
  for (const Row& row : rows(report)) {
    EXPECT_GE(std::get<std::vector<double>>(row[1].second).size(), 10u);
  }
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

TEST(KickExperiment, NobodyFallsAndTheAnkleEndsAtItsTable) {
  const Experiment& experiment = find("kick");
  ExperimentSettings settings = settingsOf(experiment);
  settings.runs = 3;
  const Report report = experiment.run(settings).report;
  EXPECT_EQ(number(report, "falls"), 0);
  EXPECT_EQ(number(report, "left_foot_falls"), 0);
  // The bar: told 10 degrees at a pitch of -60, within 0.2 of the published table.
  EXPECT_NEAR(number(report, "ankle_pitch_at_limit_deg"), -60, 0.2);
  EXPECT_NEAR(number(report, "ankle_roll_at_limit_deg"), 5.9, 0.2);
  EXPECT_NEAR(number(report, "ankle_roll_at_lower_limit_deg"), -6.5, 0.2);
  // With commands that nobody clips, the limb meets the stop where its own pitch is.
  EXPECT_NEAR(number(report, "ankle_roll_at_stop_deg"),
              number(report, "ankle_roll_stop_table_max_deg"), 0.2);
}

TEST(KickExperiment, RunsAreEqualWithoutASeedAndDifferWithOne) {
  const Experiment& experiment = find("kick");
  ExperimentSettings settings = settingsOf(experiment);
  settings.runs = 2;
  const auto spreadOf = [&](std::uint64_t seed) {
    settings.seed = seed;
    for (const Figure& figure : experiment.run(settings).report.figures) {
      if (figure.name != "sd_deg") continue;
      for (const auto& [joint, sd] : std::get<Row>(figure.value)) {
        if (joint == "RKneePitch") return std::get<double>(sd);
      }
    }
    return -1.0;
  };
  EXPECT_EQ(spreadOf(0), 0);
  EXPECT_GT(spreadOf(1), 0);
}

TEST(SinglestepExperiment, EitherLegStepsAndTheOtherStays) {
  const Experiment& experiment = find("singlestep");
  ExperimentSettings settings = settingsOf(experiment);
  settings.runs = 1;
  settings.seed = 0;
  const Report report = experiment.run(settings).report;
  for (const std::string leg : {"", "right_leg_"}) {
    EXPECT_EQ(number(report, leg + "falls"), 0);
    for (const Figure& figure : report.figures) {
      if (figure.name != leg + "step_m" && figure.name != leg + "stance_foot_moved_m") continue;
      // 0.04 m ordered; slip and gear play take and give some millimetres.
      const double ordered = figure.name == leg + "step_m" ? 0.04 : 0;
      EXPECT_NEAR(std::get<Statistics>(figure.value).mean, ordered, 0.008) << figure.name;
    }
  }
}

TEST(TaichiExperiment, StaysOnOneLegAndThenOnTheOther) {
  const Experiment& experiment = find("taichi");
  ExperimentSettings settings = settingsOf(experiment);
  settings.runs = 1;
  EXPECT_EQ(number(experiment.run(settings).report, "falls"), 0);
}

}  // namespace
}  // namespace nao::validation
