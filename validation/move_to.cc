// moveTo to random targets: does the robot arrive where odometry says, and is odometry right?
#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "validation/experiment.h"
#include "validation/trial.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""s;

constexpr double kDegree = M_PI / 180;
constexpr double kFar = 1.5;  // [m] the farthest target
constexpr Duration kAtMost = 180s;
constexpr Duration kSettling = 1s;

struct Arrival {
  Pose2 target, odometry, truth;
  double path = 0;  // [m] by odometry
  bool arrived = false;
  bool fell = false;

  double arrivalError() const { return std::hypot(odometry.x - target.x, odometry.y - target.y); }
  double arrivalTurn() const { return std::abs(wrapAngle(odometry.theta - target.theta)); }
  double odometryError() const { return std::hypot(odometry.x - truth.x, odometry.y - truth.y); }
  double odometryTurn() const { return std::abs(wrapAngle(odometry.theta - truth.theta)); }
};

// Uniform in the disc and in the heading.
Pose2 drawTarget(const ExperimentSettings& settings, int run) {
  Random random(std::max<std::uint64_t>(settings.seed, 1), "target " + std::to_string(run));
  const double distance = kFar * std::sqrt(random.uniform());
  const double direction = random.uniform(-M_PI, M_PI);
  return {distance * std::cos(direction), distance * std::sin(direction),
          random.uniform(-M_PI, M_PI)};
}

Arrival walkThere(const ExperimentSettings& settings, int run, Report& report) {
  Arrival arrival;
  arrival.target = drawTarget(settings, run);
  Trial trial(settings, seedOf(settings, run));
  trial.standUp();
  trial.record(trial.model().cycle);
  const auto outcome = trial.waitFor(trial.ask(motion::MoveTo{arrival.target, {}, {}}), kAtMost);
  trial.wait(kSettling);
  for (std::size_t i = 1; i < trial.path().size(); ++i) {
    const Pose2& from = trial.path()[i - 1].odometry;
    const Pose2& to = trial.path()[i].odometry;
    arrival.path += std::hypot(to.x - from.x, to.y - from.y);
  }
  arrival.arrived = outcome && outcome->kind == motion::MotionOutcome::Kind::Done;
  arrival.odometry = trial.here().odometry;
  arrival.truth = trial.here().truth;
  arrival.fell = trial.fell();
  report.hash = combineHash(report.hash, trial.simulation().hash());
  return arrival;
}

Picture plot(const std::vector<Arrival>& arrivals) {
  Panel panel = makePanel("Targets and places", "ahead [m]", "to the left [m]");
  Series targets{"target", {}, {}, Stroke::Points, Ink::Orange};
  Series truth{"where it stood", {}, {}, Stroke::Points, Ink::Blue};
  for (const Arrival& arrival : arrivals) {
    targets.x.push_back(arrival.target.x);
    targets.y.push_back(arrival.target.y);
    truth.x.push_back(arrival.truth.x);
    truth.y.push_back(arrival.truth.y);
    panel.series.push_back({"",
                            {arrival.target.x, arrival.truth.x},
                            {arrival.target.y, arrival.truth.y},
                            Stroke::Line,
                            Ink::Thesis});
  }
  panel.series.push_back(std::move(targets));
  panel.series.push_back(std::move(truth));
  panel.key = "outside";
  return {"moveTo", {panel}, 1, 900, 800};
}

// Of those that did not fall.
void fillReport(const std::vector<Arrival>& arrivals, Report& report) {
  std::vector<double> percent, turn, error_m, error_deg;
  double falls = 0, missed = 0, all_errors = 0, all_paths = 0;
  for (const Arrival& a : arrivals) {
    falls += a.fell;
    missed += !a.arrived;
    if (a.fell || !a.arrived) continue;
    all_errors += a.odometryError();
    all_paths += a.path;
    percent.push_back(100 * a.odometryError() / a.path);
    turn.push_back(a.odometryTurn() / kDegree);
    error_m.push_back(a.arrivalError());
    error_deg.push_back(a.arrivalTurn() / kDegree);
  }
  TextTable table = makeStatisticsTable("moveTo to random targets within 1.5 m and 180 degrees");
  report.figures = {{"targets", static_cast<double>(arrivals.size())}};
  if (!percent.empty()) {
    addStatistics("odometry_error_percent", percent, 2, report, table);
    addStatistics("odometry_error_deg", turn, 2, report, table);
    addStatistics("arrival_error_m", error_m, 5, report, table);
    addStatistics("arrival_error_deg", error_deg, 4, report, table);
    const double in_all = 100 * all_errors / all_paths;
    report.figures.push_back({"odometry_error_of_all_paths_percent", in_all});
    table.lines.push_back({"errors of all / all paths [%]", fixed(in_all, 2)});
  }
  for (const auto& [name, value] : {std::pair("falls", falls), std::pair("not_arrived", missed)}) {
    report.figures.push_back({name, value});
    table.lines.push_back({name, fixed(value, 0)});
  }
  report.tables.push_back(std::move(table));
}

Outcome run(const ExperimentSettings& settings) {
  Outcome outcome;
  outcome.report = startReport("moveto", settings);
  std::vector<Arrival> arrivals;
  for (int i = 0; i < settings.runs; ++i) {
    arrivals.push_back(walkThere(settings, i, outcome.report));
  }
  fillReport(arrivals, outcome.report);
  outcome.picture = plot(arrivals);
  return outcome;
}

}  // namespace

Experiment moveToExperiment() {
  Experiment e = makeTrialExperiment(
      "moveto", "moveTo to random targets: arrival by odometry, and odometry beside the truth.",
      run);
  e.defaults.runs = 50;
  return e;
}

}  // namespace nao::validation
