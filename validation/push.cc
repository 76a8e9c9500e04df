// A push at the torso's origin while the robot walks, in 16 phases of its gait and from four
// sides: the strongest that never makes it fall.
#include <algorithm>
#include <array>
#include <cmath>

#include "validation/experiment.h"
#include "validation/trial.h"

namespace nao::validation {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;

constexpr int kPhases = 16;
constexpr Duration kTwoSteps = 840ms;  // after which the gait repeats
constexpr Duration kUnderWay = 3s;     // until the gait is periodic
constexpr Duration kPush = 300ms;
constexpr Duration kWatch = 3s;  // a fall takes less than one

// Levels looked at: first every second newton, then half newtons below the first that fells it.
constexpr double kCoarse = 2;      // [N]
constexpr double kFine = 0.5;      // [N]
constexpr double kStrongest = 40;  // [N] nearly its weight

struct Side {
  const char* name;
  double x, y;  // direction of the force
};
constexpr std::array<Side, 4> kSides{Side{"front", -1, 0}, Side{"back", 1, 0}, Side{"left", 0, -1},
                                     Side{"right", 0, 1}};

struct Gait {
  const char* name;
  motion::MoveToward order;
  bool closed_loop;
};
const std::array<Gait, 4>& gaits() {
  static const motion::MoveToward forward{1, 0, 0, {}}, on_the_spot{1e-6, 0, 0, {}};
  static const std::array<Gait, 4> all{Gait{"forward", forward, true},
                                       Gait{"on the spot", on_the_spot, true},
                                       Gait{"forward, open loop", forward, false},
                                       Gait{"on the spot, open loop", on_the_spot, false}};
  return all;
}

/// The walking robots of all seeds, each in all phases, ready to be pushed again and again.
class Walkers {
 public:
  Walkers(const ExperimentSettings& settings, const Gait& gait) {
    for (int run = 0; run < settings.runs; ++run) {
      walkers_.push_back({std::make_unique<Trial>(settings, seedOf(settings, run)), {}});
      Trial& trial = *walkers_.back().trial;
      trial.standUp();
      trial.ask(motion::SetWalkFeedback{{gait.closed_loop, gait.closed_loop}});
      trial.ask(gait.order);
      trial.wait(kUnderWay);
      const SimTime periodic = trial.now();
      for (int phase = 0; phase < kPhases; ++phase) {
        const Duration cycle = trial.model().cycle;
        const Duration after = kTwoSteps * phase / kPhases / cycle * cycle;
        trial.wait(periodic + after - trial.now());
        walkers_.back().phases.push_back(trial.snapshot());
      }
    }
  }

  /// How many fall; with `enough`, no more are counted.
  int countFalls(const Side& side, double newton, int enough) {
    int falls = 0;
    // Phase first: one that is weak for one seed is weak for the others.
    for (std::size_t phase = 0; phase < kPhases && falls < enough; ++phase) {
      for (std::size_t i = 0; i < walkers_.size() && falls < enough; ++i) {
        falls += makesFall(walkers_[i], phase, side, newton);
      }
    }
    return falls;
  }

  int cases() const { return kPhases * static_cast<int>(walkers_.size()); }
  std::uint64_t hash() const { return hash_; }

 private:
  struct Walker {
    std::unique_ptr<Trial> trial;
    std::vector<std::shared_ptr<const Trial::Snapshot>> phases;
  };

  bool makesFall(Walker& walker, std::size_t phase, const Side& side, double newton) {
    Trial& trial = *walker.trial;
    trial.restore(*walker.phases[phase]);
    const Eigen::Rotation2Dd heading(trial.here().truth.theta);
    const Eigen::Vector2d force = heading * (newton * Eigen::Vector2d(side.x, side.y));
    trial.simulation().world().push(0, {force.x(), force.y(), 0}, kPush);
    for (const SimTime end = trial.now() + kPush + kWatch; trial.now() < end && !trial.fell();) {
      trial.wait(trial.model().cycle);
    }
    hash_ = combineHash(hash_, trial.simulation().hash());
    return trial.fell();
  }

  std::vector<Walker> walkers_;
  std::uint64_t hash_ = 0;
};

// The strongest level at which nobody falls, below the first at which somebody does.
double findSurvived(Walkers& walkers, const Side& side) {
  double level = 0;
  while (level < kStrongest && walkers.countFalls(side, level + kCoarse, 1) == 0) level += kCoarse;
  while (level < kStrongest && walkers.countFalls(side, level + kFine, 1) == 0) level += kFine;
  return level;
}

struct Found {
  Gait gait;
  std::array<double, 4> survived{};  // [N] by side
  std::array<double, 4> falls{};     // at the force asked for, by side
  int cases = 0;
  std::uint64_t hash = 0;
};

Found examine(const ExperimentSettings& settings, const Gait& gait) {
  Walkers walkers(settings, gait);
  Found found{gait, {}, {}, walkers.cases(), 0};
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    if (settings.newton > 0) {
      found.falls[i] = walkers.countFalls(kSides[i], settings.newton, walkers.cases());
    } else {
      found.survived[i] = findSurvived(walkers, kSides[i]);
    }
  }
  found.hash = walkers.hash();
  return found;
}

Panel plotRows(const std::vector<Found>& all, bool falls) {
  Panel panel = makePanel("", "", falls ? "falls" : "strongest push survived [N]");
  Series bars{"", {}, {}, Stroke::Bars, Ink::Blue};
  for (const Found& found : all) {
    for (std::size_t i = 0; i < kSides.size(); ++i) {
      bars.x.push_back(static_cast<double>(bars.x.size()));
      bars.y.push_back(falls ? found.falls[i] : found.survived[i]);
      panel.categories.push_back(std::string(found.gait.name) + ", " + kSides[i].name);
    }
  }
  panel.series = {bars};
  return panel;
}

void addFigures(const std::vector<Found>& all, bool closed_loop, bool falls_counted,
                Report& report) {
  const std::string prefix = closed_loop ? "" : "open_loop_";
  for (std::size_t i = 0; i < kSides.size(); ++i) {
    double worst = kStrongest, falls = 0;
    for (const Found& found : all) {
      if (found.gait.closed_loop != closed_loop) continue;
      worst = std::min(worst, found.survived[i]);
      falls += found.falls[i];
    }
    const std::string name = kSides[i].name;
    if (falls_counted) report.figures.push_back({prefix + "falls_" + name, falls});
    if (!falls_counted) report.figures.push_back({prefix + "survived_" + name + "_N", worst});
  }
}

// A side's figure is the worst of all gaits; those of the open loop have their own.
void fillReport(const ExperimentSettings& settings, const std::vector<Found>& all, Report& report) {
  const bool given = settings.newton > 0;
  TextTable table;
  table.title = given ? "Falls after pushes of " + fixed(settings.newton, 1) + " N and 0.3 s"
                      : "Strongest push of 0.3 s without a fall [N]";
  table.head = {"walking", "cases"};
  for (const Side& side : kSides) table.head.push_back(std::string("from ") + side.name);
  std::vector<Row> rows;
  for (const Found& found : all) {
    Row row{{"walking", std::string(found.gait.name)}, {"cases", static_cast<double>(found.cases)}};
    table.lines.push_back({found.gait.name, std::to_string(found.cases)});
    for (std::size_t i = 0; i < kSides.size(); ++i) {
      const double value = given ? found.falls[i] : found.survived[i];
      row.emplace_back(
          (given ? "falls_" : "survived_") + std::string(kSides[i].name) + (given ? "" : "_N"),
          value);
      table.lines.back().push_back(fixed(value, given ? 0 : 1));
    }
    rows.push_back(std::move(row));
    report.hash = combineHash(report.hash, found.hash);
  }
  for (const bool closed_loop : {true, false}) addFigures(all, closed_loop, given, report);
  report.figures.push_back({"rows", std::move(rows)});
  report.tables.push_back(std::move(table));
}

Outcome run(const ExperimentSettings& settings) {
  Outcome outcome;
  outcome.report = startReport("push", settings);
  std::vector<Found> all;
  for (const Gait& gait : gaits()) all.push_back(examine(settings, gait));
  fillReport(settings, all, outcome.report);
  outcome.picture = {"Pushes of 0.3 s", {plotRows(all, settings.newton > 0)}};
  return outcome;
}

}  // namespace

Experiment pushExperiment() {
  Experiment e = makeTrialExperiment(
      "push", "Pushes from four sides in 16 phases of the gait: the strongest without a fall.",
      run);
  e.choices.push_back(Choice::Newton);
  return e;
}

}  // namespace nao::validation
