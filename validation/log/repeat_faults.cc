// Faults between runs: repeats that are none, copies, and mixed purposes.
#include <algorithm>
#include <cmath>
#include <set>

#include "validation/log/fault_checks.h"
#include "validation/log/series.h"

namespace nao::validation {
namespace {

constexpr double kWindow = 0.5;     // [s] how far repeats are shifted to find their match
constexpr double kAlike = 0.7;      // correlation of commanded rates; walks are closed loops
constexpr double kBetter = 0.02;    // a shift must make them more alike by this
constexpr double kAligned = 0.015;  // [s]

// How alike the commands of two runs are at this shift.
double compare(const std::vector<JointSeries>& a, const std::vector<JointSeries>& b, int lag) {
  Correlation correlation;
  for (std::size_t j = 0; j < a.size(); ++j) {
    if (a[j].command.empty() || b[j].command.empty()) continue;
    correlation.add(differences(a[j].command), differences(b[j].command), lag);
  }
  return correlation.value();
}

void checkPair(const LogSet& set, const SetSeries& series, std::size_t first, std::size_t other,
               double dt, FaultLog& log) {
  const double unshifted = compare(series[first], series[other], 0);
  if (compare(series[first], series[first], 0) == 0) return;  // nothing is commanded
  if (unshifted > 0.999) return;
  int best_lag = 0;
  double best = unshifted;
  const int reach = static_cast<int>(kWindow / dt);
  for (int lag = -reach; lag <= reach; ++lag) {
    const double alike = compare(series[first], series[other], lag);
    if (alike > best) best = alike, best_lag = lag;
  }
  const std::string& file = set.runs[other].file;
  if (best < kAlike) {
    log.add({DataFaultKind::Misaligned,
             false,
             file,
             "",
             "",
             {},
             "its commands differ from those of " + set.runs[first].file +
                 ", of which it is said to be a repeat"});
  } else if (best > unshifted + kBetter && std::abs(best_lag * dt) > kAligned) {
    log.add({DataFaultKind::Misaligned,
             false,
             file,
             "",
             "",
             {},
             "its commands come " + fixed(1000 * std::abs(best_lag * dt), 0) + " ms " +
                 (best_lag > 0 ? "after" : "before") + " those of " + set.runs[first].file});
  }
}

// All angles of a run, one after the other; empty if none moves.
std::vector<double> collectAngles(const LogRun& run) {
  std::vector<double> all;
  bool moves = false;
  for (const auto& [name, values] : run.columns) {
    if (name.rfind("q.", 0) != 0) continue;
    for (const double x : values) {
      moves = moves || x != values.front();
      all.push_back(std::isnan(x) ? 1e300 : x);
    }
  }
  return moves ? all : std::vector<double>{};
}

}  // namespace

void checkRepeats(const LogSet& set, const SetSeries& series, double dt, FaultLog& log) {
  std::map<std::string, std::size_t> first;
  for (std::size_t r = 0; r < set.runs.size(); ++r) {
    const auto [known, is_new] = first.insert({set.runs[r].motion, r});
    if (!is_new) checkPair(set, series, known->second, r, dt, log);
  }
}

void checkCopies(const LogSet& set, FaultLog& log) {
  std::map<std::vector<double>, const LogRun*> seen;
  for (const LogRun& run : set.runs) {
    std::vector<double> angles = collectAngles(run);
    if (angles.empty()) continue;
    const auto [known, is_new] = seen.insert({std::move(angles), &run});
    if (is_new) continue;
    // Repeats without any noise are what a simulation gives; elsewhere the same readings leak.
    const LogRun& other = *known->second;
    const bool repeats = other.motion == run.motion && other.split == run.split;
    log.add({DataFaultKind::Copied,
             repeats,
             run.file,
             "",
             "",
             {},
             "the readings are those of " + other.file});
  }
}

void checkSplits(const LogSet& set, FaultLog& log) {
  std::map<std::string, const LogRun*> first;
  for (const LogRun& run : set.runs) first.insert({run.motion, &run});
  if (first.size() < 2) return;  // one motion is split by runs
  std::set<std::string> told;
  for (const LogRun& run : set.runs) {
    const LogRun& other = *first.at(run.motion);
    if (other.split == run.split || !told.insert(run.motion).second) continue;
    log.add({DataFaultKind::Split,
             false,
             run.file,
             "",
             "",
             {},
             "the motion " + run.motion + " is for " + nameOf(run.split) + " here and for " +
                 nameOf(other.split) + " in " + other.file});
  }
}

}  // namespace nao::validation
