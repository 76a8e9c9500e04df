// The fastest ways ALMotion documents, for ten seconds each: ahead with steps of 0.08 m (19 cm/s),
// backwards and sideways as far as their limits allow.
#include <algorithm>
#include <cmath>

#include "validation/experiment.h"
#include "validation/trial.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""s;

constexpr Duration kStarting = 2s;  // after that the speed is even

struct Way {
  const char* name;
  motion::MoveToward order;
  double x, y;  // direction
};

std::vector<Way> ways() {
  motion::GaitConfig longest;  // control-walk pages: upper ends of MaxStepX and MaxStepY
  longest.max_step_x = 0.08;
  longest.max_step_y = 0.16;
  return {{"forward, MaxStepX 0.08", {1, 0, 0, longest}, 1, 0},
          {"forward", {1, 0, 0, {}}, 1, 0},
          {"backward", {-1, 0, 0, {}}, -1, 0},
          {"left", {0, 1, 0, {}}, 0, 1},
          {"right", {0, -1, 0, {}}, 0, -1},
          {"left, MaxStepY 0.16", {0, 1, 0, longest}, 0, 1},
          {"right, MaxStepY 0.16", {0, -1, 0, longest}, 0, -1}};
}

struct Result {
  std::string way;
  std::vector<double> speed;     // [m/s] true, along the way
  std::vector<double> odometry;  // [m/s]
  std::vector<std::vector<TrialPoint>> paths;
  double falls = 0;
};

void walkOnce(const ExperimentSettings& settings, int run, const Way& way, Result& result,
              Report& report) {
  Trial trial(settings, seedOf(settings, run));
  trial.standUp();
  trial.record(std::chrono::milliseconds(100));
  trial.ask(way.order);
  trial.wait(kStarting);
  const TrialPoint from = trial.here();
  trial.wait(settings.duration - kStarting);
  const TrialPoint to = trial.here();
  const bool fell = trial.fell();
  trial.stopWalk();
  const auto speed = [&](const Pose2& a, const Pose2& b) {
    return ((b.x - a.x) * way.x + (b.y - a.y) * way.y) / (to.t - from.t);
  };
  result.speed.push_back(speed(from.truth, to.truth));
  result.odometry.push_back(speed(from.odometry, to.odometry));
  result.paths.push_back(trial.path());
  result.falls += fell || trial.fell();  // the stop belongs to the walk
  report.hash = combineHash(report.hash, trial.simulation().hash());
}

Picture plot(const std::vector<Result>& results) {
  Panel panel = makePanel("Seen from above", "ahead [m]", "to the left [m]");
  const Ink inks[] = {Ink::Blue, Ink::Sky, Ink::Orange, Ink::Green, Ink::Purple};
  for (std::size_t i = 0; i < results.size(); ++i) {
    for (const auto& path : results[i].paths) {
      Series way{&path == &results[i].paths.front() ? results[i].way : "",
                 {},
                 {},
                 Stroke::Line,
                 inks[i % 5]};
      for (const TrialPoint& point : path) {
        way.x.push_back(point.truth.x);
        way.y.push_back(point.truth.y);
      }
      panel.series.push_back(std::move(way));
    }
  }
  panel.key = "outside";
  return {"Full speed", {panel}, 1, 1000, 700};
}

Outcome run(const ExperimentSettings& settings) {
  if (settings.duration <= kStarting) {
    throw InputError("--duration: expected more than 2 s, after which the speed is taken");
  }
  Outcome outcome;
  Report& report = outcome.report;
  report = startReport("fastwalk", settings);
  TextTable table{"Full speed for " + fixed(toSeconds(settings.duration), 0) + " s",
                  {"way", "speed [m/s]", "slowest", "odometry", "falls"},
                  {}};
  std::vector<Result> results;
  std::vector<Row> rows;
  for (const Way& way : ways()) {
    Result result;
    result.way = way.name;
    for (int i = 0; i < settings.runs; ++i) walkOnce(settings, i, way, result, report);
    const Statistics speed = calcStatistics(result.speed);
    const double odometry = calcStatistics(result.odometry).mean;
    rows.push_back({{"way", result.way},
                    {"speed_m_per_s", speed.mean},
                    {"speed_min_m_per_s", speed.min},
                    {"odometry_m_per_s", odometry},
                    {"falls", result.falls}});
    table.lines.push_back({result.way, fixed(speed.mean, 4), fixed(speed.min, 4),
                           fixed(odometry, 4), fixed(result.falls, 0)});
    results.push_back(std::move(result));
  }
  double falls = 0;
  for (const Result& result : results) falls += result.falls;
  report.figures = {{"speed_m_per_s", calcStatistics(results.front().speed)},
                    {"falls", falls},
                    {"rows", std::move(rows)}};
  report.tables.push_back(std::move(table));
  outcome.picture = plot(results);
  return outcome;
}

}  // namespace

Experiment fastWalkExperiment() {
  Experiment e =
      makeTrialExperiment("fastwalk", "Full speed ahead, backwards and sideways for 10 s.", run);
  e.choices.push_back(Choice::Duration);
  e.defaults.duration = 10s;
  return e;
}

}  // namespace nao::validation
