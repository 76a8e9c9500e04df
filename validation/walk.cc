// Thesis section 5.3.2, figure 23: a walk straight on at full speed for "5 s", and a turn on the
// spot for as long. Five seconds are twelve steps of 0.42 s; the step after them only brings the
// other foot beside. Both start and end standing.
#include <cmath>

#include "validation/experiment.h"
#include "validation/trial.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr double kDegree = M_PI / 180;
constexpr int kSteps = 12;
constexpr Duration kIntoLastStep = 200ms;  // the stop leaves a step under way as it is
constexpr Duration kAtMost = 15s;
constexpr Duration kPlotted = 50ms;

struct Walk {
  TrialPoint end;
  std::vector<TrialPoint> path;
  bool fell = false;
  std::uint64_t hash = 0;
};

Walk walk(const ExperimentSettings& settings, int run, const motion::MoveToward& order) {
  Trial trial(settings, seedOf(settings, run));
  trial.standUp();
  trial.record(kPlotted);
  trial.ask(order);
  trial.waitForLandings(kSteps - 1, kAtMost);
  trial.wait(kIntoLastStep);
  trial.stopWalk();
  return {trial.here(), trial.path(), trial.fell(), trial.simulation().hash()};
}

std::vector<Walk> walks(const ExperimentSettings& settings, const motion::MoveToward& order,
                        Report& report) {
  std::vector<Walk> all;
  for (int run = 0; run < settings.runs; ++run) {
    all.push_back(walk(settings, run, order));
    report.hash = combineHash(report.hash, all.back().hash);
  }
  return all;
}

template <class Measure>
std::vector<double> valuesOf(const std::vector<Walk>& walks, Measure measure) {
  std::vector<double> values;
  for (const Walk& walk : walks) values.push_back(measure(walk.end));
  return values;
}

double countFalls(const std::vector<Walk>& walks) {
  double falls = 0;
  for (const Walk& walk : walks) falls += walk.fell;
  return falls;
}

template <class X, class Y>
Series curve(const Walk& walk, X x, Y y, Stroke stroke, Ink ink) {
  Series series{"", {}, {}, stroke, ink};
  for (const TrialPoint& point : walk.path) {
    series.x.push_back(x(point));
    series.y.push_back(y(point));
  }
  return series;
}

Picture plotWalks(const std::vector<Walk>& walks) {
  Panel way = makePanel("The way seen from above", "ahead [m]", "to the left [m]");
  Panel far = makePanel("Distance", "time [s]", "ahead [m]");
  const auto t = [](const TrialPoint& p) { return p.t; };
  for (std::size_t i = 0; i < walks.size(); ++i) {
    way.series.push_back(curve(
        walks[i], [](auto& p) { return p.truth.x; }, [](auto& p) { return p.truth.y; },
        Stroke::Line, Ink::Blue));
    far.series.push_back(curve(
        walks[i], t, [](auto& p) { return p.truth.x; }, Stroke::Line, Ink::Blue));
  }
  way.series.push_back(curve(
      walks[0], [](auto& p) { return p.odometry.x; }, [](auto& p) { return p.odometry.y; },
      Stroke::Dashed, Ink::Orange));
  far.series.push_back(curve(
      walks[0], t, [](auto& p) { return p.odometry.x; }, Stroke::Dashed, Ink::Orange));
  for (Panel* panel : {&way, &far}) {
    panel->series.front().label = "where it was, each run";
    panel->series.back().label = "odometry";
    panel->key = "top left";
  }
  way.y_range = {-0.1, 0.1};
  return {"Walk at full speed (thesis figure 23)", {way, far}, 1, 900, 900};
}

Outcome runWalk(const ExperimentSettings& settings) {
  Outcome outcome;
  Report& report = outcome.report;
  report = startReport("walk", settings);
  const std::vector<Walk> all = walks(settings, {1, 0, 0, {}}, report);
  TextTable table = makeStatisticsTable("Twelve steps at full speed, from standing to standing");
  const auto add = [&](const char* name, int digits, auto measure) {
    addStatistics(name, valuesOf(all, measure), digits, report, table);
  };
  add("forward_distance_m", 4, [](const TrialPoint& p) { return p.truth.x; });
  add("lateral_drift_m", 4, [](const TrialPoint& p) { return std::abs(p.truth.y); });
  add("heading_error_deg", 2,
      [](const TrialPoint& p) { return std::abs(p.truth.theta) / kDegree; });
  add("odometry_distance_m", 4, [](const TrialPoint& p) { return p.odometry.x; });
  report.figures.push_back({"falls", countFalls(all)});
  table.lines.push_back({"falls", fixed(countFalls(all), 0)});
  report.tables.push_back(std::move(table));
  report.remarks.push_back("The thesis: 0.48 m on the real robot, 0.32 m in its simulator.");
  outcome.picture = plotWalks(all);
  return outcome;
}

Picture plotTurns(const std::vector<Walk>& left, const std::vector<Walk>& right) {
  Panel panel = makePanel("Heading", "time [s]", "to the left [deg]");
  const auto t = [](const TrialPoint& p) { return p.t; };
  for (const auto* walks : {&left, &right}) {
    for (const Walk& walk : *walks) {
      panel.series.push_back(curve(
          walk, t, [](auto& p) { return p.truth.theta / kDegree; }, Stroke::Line, Ink::Blue));
    }
  }
  panel.series.front().label = "where it looked, each run";
  for (const auto* walks : {&left, &right}) {
    panel.series.push_back(curve(
        walks->front(), t, [](auto& p) { return p.odometry.theta / kDegree; }, Stroke::Dashed,
        Ink::Orange));
  }
  panel.series.back().label = "odometry";
  panel.key = "top left";
  return {"Turn on the spot at full rate (thesis section 5.3.2)", {panel}};
}

Outcome runTurn(const ExperimentSettings& settings) {
  Outcome outcome;
  Report& report = outcome.report;
  report = startReport("turn", settings);
  const std::vector<Walk> left = walks(settings, {0, 0, 1, {}}, report);
  const std::vector<Walk> right = walks(settings, {0, 0, -1, {}}, report);
  TextTable table = makeStatisticsTable("Twelve steps on the spot at full rate");
  const auto turned = [](const TrialPoint& p) { return std::abs(p.truth.theta) / kDegree; };
  const auto counted = [](const TrialPoint& p) { return std::abs(p.odometry.theta) / kDegree; };
  const auto moved = [](const TrialPoint& p) { return std::hypot(p.truth.x, p.truth.y); };
  addStatistics("turn_left_deg", valuesOf(left, turned), 2, report, table);
  addStatistics("turn_right_deg", valuesOf(right, turned), 2, report, table);
  addStatistics("odometry_left_deg", valuesOf(left, counted), 2, report, table);
  addStatistics("odometry_right_deg", valuesOf(right, counted), 2, report, table);
  addStatistics("drift_left_m", valuesOf(left, moved), 4, report, table);
  addStatistics("drift_right_m", valuesOf(right, moved), 4, report, table);
  const double falls = countFalls(left) + countFalls(right);
  report.figures.push_back({"falls", falls});
  table.lines.push_back({"falls", fixed(falls, 0)});
  report.tables.push_back(std::move(table));
  report.remarks.push_back(
      "The thesis: 210 degrees on the real robot, about half of it in its simulator.");
  outcome.picture = plotTurns(left, right);
  return outcome;
}

}  // namespace

Experiment walkExperiment() {
  return makeTrialExperiment("walk", "Twelve steps straight on at full speed (thesis figure 23).",
                             runWalk);
}

Experiment turnExperiment() {
  return makeTrialExperiment("turn", "Twelve steps on the spot at full rate, both ways.", runTurn);
}

}  // namespace nao::validation
