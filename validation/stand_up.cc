// A Nao is knocked over onto its back, its belly and to both sides and told to stand: does it, with
// which try, and how long does it take? In every run with another friction of the floor and other
// masses.
#include <algorithm>
#include <array>

#include "validation/experiment.h"
#include "validation/posture_trial.h"

namespace nao::validation {
namespace {

constexpr double kPush = 45;  // [N] nearly its weight

struct Side {
  std::string name;  // of the robot, that is down
  double x, y;       // [N] of the push
};
const std::array<Side, 4>& sides() {
  static const std::array<Side, 4> all{Side{"back", -kPush, 0}, Side{"front", kPush, 0},
                                       Side{"left", 0, kPush}, Side{"right", 0, -kPush}};
  return all;
}

struct Run {
  std::uint64_t seed = 0;
  double friction = 0;
  Arrival arrival;
};

struct Found {
  std::string side;
  std::vector<Run> runs;

  double successes() const { return successesWithin(PostureTrial::kTries); }
  double successesWithin(int tries) const {
    return static_cast<double>(std::count_if(runs.begin(), runs.end(), [tries](const Run& run) {
      return run.arrival.there && run.arrival.tries <= tries;
    }));
  }
};

Run standUp(const ExperimentSettings& settings, int i, const Side& side, Report& report) {
  Run run{seedOf(settings, i), 0, {}};
  PostureTrial trial(settings, run.seed);
  const std::map<std::string, double> draw = trial.trial().simulation().world().draw();
  if (report.draw.empty()) report.draw = draw;
  const auto friction = draw.find("nao.floor_friction.friction");
  if (friction != draw.end()) run.friction = friction->second;
  trial.knockOver(side.x, side.y);
  run.arrival = trial.goTo("Stand");
  report.hash = combineHash(report.hash, trial.trial().simulation().hash());
  return run;
}

std::vector<double> collect(const Found& found, double (*value)(const Run&)) {
  std::vector<double> values;
  for (const Run& run : found.runs) {
    if (run.arrival.there) values.push_back(value(run));
  }
  return values;
}

// Tries, time and tilt are those of the runs that end standing.
void addSide(const Found& found, Report& report, TextTable& table) {
  const double all = static_cast<double>(found.runs.size());
  const std::string of = " of " + fixed(all, 0);
  report.figures.push_back({found.side + "_success", found.successes()});
  report.figures.push_back({found.side + "_first_try", found.successesWithin(1)});
  table.lines.push_back({found.side + ", stood up", fixed(found.successes(), 0) + of});
  table.lines.push_back(
      {found.side + ", at the first try", fixed(found.successesWithin(1), 0) + of});
  if (found.successes() == 0) return;
  addStatistics(found.side + "_tries",
                collect(found, [](const Run& r) { return static_cast<double>(r.arrival.tries); }),
                2, report, table);
  addStatistics(found.side + "_time_s",
                collect(found, [](const Run& r) { return r.arrival.seconds; }), 1, report, table);
  addStatistics(found.side + "_tilt_deg",
                collect(found, [](const Run& r) { return r.arrival.tilt_deg; }), 1, report, table);
}

void addRows(const std::vector<Found>& all, Report& report) {
  TextTable table{"Every run",
                  {"down on", "seed", "friction", "stands", "tries", "time [s]", "tilt [deg]"},
                  {}};
  std::vector<Row> rows;
  for (const Found& found : all) {
    for (const Run& run : found.runs) {
      const Arrival& a = run.arrival;
      rows.push_back({{"side", found.side},
                      {"seed", static_cast<double>(run.seed)},
                      {"friction", run.friction},
                      {"stands", a.there ? 1.0 : 0.0},
                      {"tries", static_cast<double>(a.tries)},
                      {"time_s", a.seconds},
                      {"tilt_deg", a.tilt_deg}});
      table.lines.push_back({found.side, std::to_string(run.seed), fixed(run.friction, 2),
                             a.there ? "yes" : "no", std::to_string(a.tries), fixed(a.seconds, 1),
                             fixed(a.tilt_deg, 1)});
    }
  }
  report.figures.push_back({"rows", std::move(rows)});
  report.tables.push_back(std::move(table));
}

Picture plot(const std::vector<Found>& all) {
  Picture picture{"Standing up", {}, 2, 1200, 800};
  for (const Found& found : all) {
    Panel panel = makePanel("from the " + found.side, "friction of the floor", "time [s]");
    Series up{"stands", {}, {}, Stroke::Points, Ink::Blue};
    Series down{"does not", {}, {}, Stroke::Points, Ink::Vermilion};
    for (const Run& run : found.runs) {
      Series& series = run.arrival.there ? up : down;
      series.x.push_back(run.friction);
      series.y.push_back(run.arrival.seconds);
    }
    for (Series* series : {&up, &down}) {
      if (!series->x.empty()) panel.series.push_back(*series);
    }
    panel.key = "outside";
    picture.panels.push_back(std::move(panel));
  }
  return picture;
}

Outcome run(const ExperimentSettings& settings) {
  Outcome outcome;
  Report& report = outcome.report;
  report = startReport("standup", settings);
  std::vector<Found> all;
  for (const Side& side : sides()) {
    all.push_back({side.name, {}});
    for (int i = 0; i < settings.runs; ++i) {
      all.back().runs.push_back(standUp(settings, i, side, report));
    }
  }
  TextTable table = makeStatisticsTable("Standing up after a fall");
  for (const Found& found : all) addSide(found, report, table);
  report.figures.push_back({"runs", static_cast<double>(settings.runs)});
  report.tables.push_back(std::move(table));
  addRows(all, report);
  outcome.picture = plot(all);
  return outcome;
}

}  // namespace

Experiment standUpExperiment() {
  Experiment e = makeTrialExperiment(
      "standup", "A Nao knocked over onto its back, its belly or a side stands up.", run);
  e.defaults.runs = 20;
  return e;
}

}  // namespace nao::validation
