// A walk straight on at full speed up, down and across slopes; on the flat with other friction and
// with a heavier and a lighter body.
#include <algorithm>
#include <array>
#include <cmath>

#include "validation/experiment.h"
#include "validation/trial.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""s;

constexpr double kDegree = M_PI / 180;
constexpr int kSteepest = 6;  // [deg]
constexpr std::array<double, 3> kFrictions{0.3, 0.65, 1.0};
constexpr double kMassDifference = 0.05;

struct Case {
  std::string name;
  Conditions conditions;
  double slope_deg = 0;  // positive: it goes up, or leans to its right
  double falls = 0;
  std::vector<double> distance;  // [m]
  std::vector<double> drift;     // [m]
};

std::vector<Case> cases() {
  std::vector<Case> all;
  const auto add = [&all](std::string name, const Conditions& conditions, double slope_deg) {
    all.push_back({std::move(name), conditions, slope_deg, 0, {}, {}});
  };
  for (int i = -kSteepest; i <= kSteepest; ++i) {
    Conditions along;
    along.slope = i * kDegree;
    add(i > 0 ? "up" : i < 0 ? "down" : "flat", along, i);
    Conditions across = along;
    across.uphill = M_PI / 2;
    if (i != 0) add("across", across, i);
  }
  for (const double friction : kFrictions) {
    for (const double slope_deg : {0.0, 3.0, -3.0}) {
      Conditions conditions;
      conditions.friction = friction;
      conditions.slope = slope_deg * kDegree;
      add("friction " + fixed(friction, 2), conditions, slope_deg);
    }
  }
  for (const double part : {-kMassDifference, kMassDifference}) {
    Conditions conditions;
    conditions.mass_difference = part;
    add("mass " + fixed(100 * part, 0) + " %", conditions, 0);
  }
  return all;
}

void walk(const ExperimentSettings& settings, int run, Case& test, Report& report) {
  Trial trial(settings, seedOf(settings, run), test.conditions);
  trial.standUp();
  trial.ask(motion::MoveToward{1, 0, 0, {}});
  trial.wait(settings.duration);
  trial.stopWalk();
  test.falls += trial.fell();
  test.distance.push_back(trial.here().truth.x);
  test.drift.push_back(std::abs(trial.here().truth.y));
  report.hash = combineHash(report.hash, trial.simulation().hash());
}

// Up to here, no slope in any direction made a robot fall.
double findSteepest(const std::vector<Case>& all) {
  double first_fall = kSteepest + 1;
  for (const Case& test : all) {
    const bool plain = test.conditions.friction == 0 && test.conditions.mass_difference == 0;
    if (plain && test.falls > 0) first_fall = std::min(first_fall, std::abs(test.slope_deg));
  }
  return std::max(0.0, first_fall - 1);
}

Picture plot(const std::vector<Case>& all) {
  Panel panel = makePanel("Falls", "slope [deg]", "falls");
  Series along{"up and down", {}, {}, Stroke::LinePoints, Ink::Blue};
  Series across{"across", {}, {}, Stroke::LinePoints, Ink::Orange};
  for (const Case& test : all) {
    if (test.conditions.friction != 0 || test.conditions.mass_difference != 0) continue;
    Series& series = test.name == "across" ? across : along;
    series.x.push_back(test.slope_deg);
    series.y.push_back(test.falls);
  }
  panel.series = {along, across};
  return {"Walking on slopes", {panel}};
}

Outcome run(const ExperimentSettings& settings) {
  Outcome outcome;
  Report& report = outcome.report;
  report = startReport("slope", settings);
  TextTable table{"Full speed ahead for " + fixed(toSeconds(settings.duration), 0) + " s, " +
                      std::to_string(settings.runs) + " runs each",
                  {"way", "slope [deg]", "falls", "distance [m]", "drift [m]"},
                  {}};
  std::vector<Case> all = cases();
  std::vector<Row> rows;
  double other_falls = 0;
  for (Case& test : all) {
    for (int i = 0; i < settings.runs; ++i) walk(settings, i, test, report);
    const double distance = calcStatistics(test.distance).mean;
    const double drift = calcStatistics(test.drift).mean;
    const bool plain = test.conditions.friction == 0 && test.conditions.mass_difference == 0;
    if (!plain) other_falls += test.falls;
    rows.push_back({{"way", test.name},
                    {"slope_deg", test.slope_deg},
                    {"falls", test.falls},
                    {"distance_m", distance},
                    {"drift_m", drift}});
    table.lines.push_back({test.name, fixed(test.slope_deg, 0), fixed(test.falls, 0),
                           fixed(distance, 3), fixed(drift, 3)});
  }
  report.figures = {{"max_slope_deg", findSteepest(all)},
                    {"falls_with_other_friction_or_mass", other_falls},
                    {"rows", std::move(rows)}};
  report.tables.push_back(std::move(table));
  report.remarks.push_back("Without a fall up to " + fixed(findSteepest(all), 0) +
                           " degrees in every direction.");
  outcome.picture = plot(all);
  return outcome;
}

}  // namespace

Experiment slopeExperiment() {
  Experiment e = makeTrialExperiment(
      "slope", "Walks on slopes, on slippery and rough ground, and with a wrong mass.", run);
  e.choices.push_back(Choice::Duration);
  e.defaults.duration = 10s;
  return e;
}

}  // namespace nao::validation
