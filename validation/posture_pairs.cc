// goToPosture from every posture to every other one, in every run with another friction of the
// floor and other masses.
#include <algorithm>
#include <array>

#include "validation/experiment.h"
#include "validation/posture_trial.h"

namespace nao::validation {
namespace {

/// Over the runs.
struct Pair {
  std::string from, to;
  double reached = 0;
  std::vector<double> tries;    // of those that arrived
  std::vector<double> seconds;  // likewise
};

std::vector<std::string> postureNames(const ExperimentSettings& settings) {
  std::vector<std::string> names;
  const auto robot = loadRobot(settings);
  for (const Posture& posture : robot->postures) {
    if (posture.name.rfind('_', 0) != 0) names.push_back(posture.name);  // NaoQi's own ones
  }
  return names;
}

std::vector<Pair> allPairs(const std::vector<std::string>& names) {
  std::vector<Pair> pairs;
  for (const std::string& from : names) {
    for (const std::string& to : names) {
      if (from != to) pairs.push_back({from, to, 0, {}, {}});
    }
  }
  return pairs;
}

// From a place that was not reached nothing else is. Where a pair begins, the robot went by itself.
void tryAll(const ExperimentSettings& settings, int run, std::vector<Pair>& pairs, Report& report) {
  PostureTrial robot(settings, seedOf(settings, run));
  if (report.draw.empty()) report.draw = robot.trial().simulation().world().draw();
  const auto standing = robot.trial().snapshot();
  auto begin = standing;
  std::string place;
  bool is_there = false;
  for (Pair& pair : pairs) {
    if (pair.from != place) {
      robot.trial().restore(*standing);
      place = pair.from;
      is_there = robot.goTo(place).there;
      begin = robot.trial().snapshot();
    }
    robot.trial().restore(*begin);
    if (!is_there) continue;
    const Arrival arrival = robot.goTo(pair.to);
    report.hash = combineHash(report.hash, robot.trial().simulation().hash());
    if (!arrival.there) continue;
    ++pair.reached;
    pair.tries.push_back(arrival.tries);
    pair.seconds.push_back(arrival.seconds);
  }
}

TextTable makeMatrix(const std::vector<std::string>& names, const std::vector<Pair>& pairs,
                     int runs) {
  TextTable table{
      "Reached, of " + std::to_string(runs) + " runs, from (row) to (column)", {""}, {}};
  for (const std::string& to : names) table.head.push_back(to);
  for (const std::string& from : names) {
    table.lines.push_back({from});
    for (const std::string& to : names) {
      const auto is_pair = [&](const Pair& p) { return p.from == from && p.to == to; };
      const auto at = std::find_if(pairs.begin(), pairs.end(), is_pair);
      table.lines.back().push_back(at == pairs.end() ? "-" : fixed(at->reached, 0));
    }
  }
  return table;
}

std::vector<Row> makeRows(const std::vector<Pair>& pairs) {
  std::vector<Row> rows;
  for (const Pair& pair : pairs) {
    const bool ever = !pair.tries.empty();
    rows.push_back({{"from", pair.from},
                    {"to", pair.to},
                    {"reached", pair.reached},
                    {"tries", ever ? calcStatistics(pair.tries).mean : 0.0},
                    {"time_s", ever ? calcStatistics(pair.seconds).mean : 0.0}});
  }
  return rows;
}

// A pair is reached if it is in every run.
void fillReport(const std::vector<std::string>& names, const std::vector<Pair>& pairs,
                Report& report) {
  double always = 0, times = 0;
  for (const Pair& pair : pairs) {
    always += pair.reached == report.runs;
    times += pair.reached;
  }
  const double count = static_cast<double>(pairs.size());
  report.figures = {{"pairs", count},
                    {"reached", always},
                    {"ways_tried", count * report.runs},
                    {"ways_reached", times},
                    {"rows", makeRows(pairs)}};
  report.tables.push_back(makeMatrix(names, pairs, report.runs));
  report.remarks.push_back(fixed(always, 0) + " of " + fixed(count, 0) +
                           " pairs of postures reached in every run, " + fixed(times, 0) + " of " +
                           fixed(count * report.runs, 0) + " times in all.");
}

Picture plot(const std::vector<std::string>& names, const std::vector<Pair>& pairs) {
  constexpr std::array<Ink, 8> kInks{Ink::Blue,   Ink::Orange, Ink::Green, Ink::Vermilion,
                                     Ink::Purple, Ink::Sky,    Ink::Black, Ink::Thesis};
  Panel panel = makePanel("Mean time to get there, by posture at the start", "", "time [s]");
  panel.categories = names;
  panel.key = "outside";
  for (std::size_t i = 0; i < names.size(); ++i) {
    Series series{names[i], {}, {}, Stroke::Points, kInks[i % kInks.size()]};
    for (const Pair& pair : pairs) {
      if (pair.from != names[i] || pair.seconds.empty()) continue;
      const auto to = std::find(names.begin(), names.end(), pair.to) - names.begin();
      series.x.push_back(static_cast<double>(to));
      series.y.push_back(calcStatistics(pair.seconds).mean);
    }
    if (!series.x.empty()) panel.series.push_back(std::move(series));
  }
  return {"Postures from postures", {panel}, 1, 1100, 560};
}

Outcome run(const ExperimentSettings& settings) {
  Outcome outcome;
  outcome.report = startReport("postures", settings);
  const std::vector<std::string> names = postureNames(settings);
  std::vector<Pair> pairs = allPairs(names);
  for (int i = 0; i < settings.runs; ++i) tryAll(settings, i, pairs, outcome.report);
  fillReport(names, pairs, outcome.report);
  outcome.picture = plot(names, pairs);
  return outcome;
}

}  // namespace

Experiment posturesExperiment() {
  return makeTrialExperiment("postures", "goToPosture from every posture to every other one.", run);
}

}  // namespace nao::validation
