// Random velocities that change every one to three seconds; and, if asked for, a long way straight
// on. How often does the robot fall?
#include <algorithm>
#include <cmath>

#include "core/random.h"
#include "validation/experiment.h"
#include "validation/trial.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""s;

constexpr double kShortest = 1;  // [s] of a command
constexpr double kLongest = 3;   // [s]
constexpr double kStops = 0.15;  // of the commands; free

// A metre-long walk is split into legs of robots of ten seeds, as a user's long walks would be.
constexpr int kWalkers = 10;
constexpr Duration kLap = 10s;       // distance is added up as often
constexpr double kNoProgress = 0.1;  // [m] in a lap: the robot is not walking any more

motion::MotionAction drawCommand(Random& random) {
  motion::MoveToward toward;
  toward.config.max_step_frequency = random.uniform();
  toward.x = random.uniform(-1, 1);
  toward.y = random.uniform(-1, 1);
  toward.theta = random.uniform(-1, 1);
  if (random.uniform() < kStops) return motion::StopMove{};
  return toward;
}

struct Sequence {
  std::vector<TrialPoint> path;
  bool fell = false;
};

Sequence walkRandomly(const ExperimentSettings& settings, int run, Report& report) {
  Trial trial(settings, seedOf(settings, run));
  Random random(seedOf(settings, run) + 1, "commands");
  trial.standUp();
  trial.record(std::chrono::milliseconds(200));
  while (trial.here().t < toSeconds(settings.duration) && !trial.fell()) {
    trial.ask(drawCommand(random));
    const double left = toSeconds(settings.duration) - trial.here().t;
    trial.wait(fromSeconds(std::min(left, random.uniform(kShortest, kLongest))));
  }
  report.hash = combineHash(report.hash, trial.simulation().hash());
  return {trial.path(), trial.fell()};
}

// Every fall, or stop without one, ends a walker's turn.
struct LongWalk {
  double metres = 0;
  double falls = 0;
};

void walkFar(const ExperimentSettings& settings, int run, double metres, LongWalk& walk) {
  Trial trial(settings, seedOf(settings, run));
  trial.standUp();
  trial.ask(motion::MoveToward{1, 0, 0, {}});
  for (double gone = 0; gone < metres;) {
    const Pose2 from = trial.here().truth;
    trial.wait(kLap);
    const Pose2 to = trial.here().truth;
    const double lap = std::hypot(to.x - from.x, to.y - from.y);
    if (trial.fell() || lap < kNoProgress) {
      ++walk.falls;
      return;
    }
    gone += lap;
    walk.metres += lap;
  }
}

LongWalk walkFar(const ExperimentSettings& settings) {
  LongWalk walk;
  for (int run = 0; run < kWalkers; ++run) {
    walkFar(settings, run, settings.metres / kWalkers, walk);
  }
  return walk;
}

Picture plot(const std::vector<Sequence>& sequences) {
  Panel panel = makePanel("Seen from above", "ahead [m]", "to the left [m]");
  for (const Sequence& sequence : sequences) {
    Series way{"", {}, {}, Stroke::Line, sequence.fell ? Ink::Vermilion : Ink::Sky};
    for (const TrialPoint& point : sequence.path) {
      way.x.push_back(point.truth.x);
      way.y.push_back(point.truth.y);
    }
    panel.series.push_back(std::move(way));
  }
  return {"Random velocities (a red way ends in a fall)", {panel}, 1, 900, 800};
}

Outcome run(const ExperimentSettings& settings) {
  Outcome outcome;
  Report& report = outcome.report;
  report = startReport("randomwalk", settings);
  std::vector<Sequence> sequences;
  std::vector<double> fallen;  // seeds
  double falls = 0;
  for (int i = 0; i < settings.runs; ++i) {
    sequences.push_back(walkRandomly(settings, i, report));
    falls += sequences.back().fell;
    if (sequences.back().fell) fallen.push_back(static_cast<double>(seedOf(settings, i)));
  }
  TextTable table{"Random velocities", {"walk", "falls"}, {}};
  const std::string length = fixed(toSeconds(settings.duration), 0) + " s";
  table.lines.push_back(
      {std::to_string(settings.runs) + " sequences of " + length, fixed(falls, 0)});
  report.figures = {{"sequences", static_cast<double>(settings.runs)},
                    {"falls", falls},
                    {"rows", std::vector<Row>{{{"seeds_that_fell", fallen}}}}};
  if (settings.metres > 0) {
    const LongWalk walk = walkFar(settings);
    report.figures.push_back({"straight_on_m", walk.metres});
    report.figures.push_back({"straight_on_falls", walk.falls});
    table.lines.push_back({fixed(walk.metres, 1) + " m straight on", fixed(walk.falls, 0)});
  }
  report.tables.push_back(std::move(table));
  outcome.picture = plot(sequences);
  return outcome;
}

}  // namespace

Experiment randomWalkExperiment() {
  Experiment e = makeTrialExperiment(
      "randomwalk", "Random velocities, 30 s a sequence: how often does it fall?", run);
  e.choices.insert(e.choices.end(), {Choice::Duration, Choice::Metres});
  e.defaults.runs = 100;
  e.defaults.duration = 30s;
  return e;
}

}  // namespace nao::validation
