// Faults of the rows as such: their times, repeated readings, coarse steps, dead channels.
#include <algorithm>
#include <cmath>

#include "validation/log/fault_checks.h"
#include "validation/log/series.h"

namespace nao::validation {
namespace {

constexpr double kGap = 2.5;         // times the usual step: rows are missing
constexpr double kIrregular = 0.75;  // of the median: spread of the steps, 5 to 95 %
constexpr double kRateFactor = 1.8;  // from the stated rate; motions of one set may differ by less

std::size_t rowOf(std::size_t sample) { return sample + 2; }  // below the header

std::string inMs(double seconds) { return fixed(1000 * seconds, 1) + " ms"; }

void checkOrder(const LogRun& run, FaultLog& log) {
  std::size_t wrong = 0, first = 0;
  for (std::size_t i = 1; i < run.t.size(); ++i) {
    if (run.t[i] > run.t[i - 1]) continue;
    if (wrong++ == 0) first = i;
  }
  if (wrong == 0) return;
  log.add({DataFaultKind::Clock, false, run.file, "", "", rowOf(first),
           "the time does not rise, " + std::to_string(wrong) + " times in this run"});
}

void checkSteps(const LogSet& set, const LogRun& run, FaultLog& log) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < run.t.size(); ++i) {
    if (run.t[i] > run.t[i - 1]) steps.push_back(run.t[i] - run.t[i - 1]);
  }
  if (steps.size() < 10) return;
  std::sort(steps.begin(), steps.end());
  const auto at = [&](double part) {
    return steps[static_cast<std::size_t>(part * static_cast<double>(steps.size() - 1))];
  };
  const double median = at(0.5);
  const bool irregular = at(0.95) - at(0.05) > kIrregular * median;
  if (irregular) {
    log.add({DataFaultKind::Rate,
             false,
             run.file,
             "",
             "",
             {},
             "rows come irregularly, every " + inMs(at(0.05)) + " to " + inMs(at(0.95))});
  } else if (median * set.rate > kRateFactor || median * set.rate < 1 / kRateFactor) {
    log.add({DataFaultKind::Rate,
             false,
             run.file,
             "",
             "",
             {},
             "a row comes every " + inMs(median) + ", the set states " + inMs(1 / set.rate)});
  }
  const double usual = irregular ? at(0.95) : median;
  for (std::size_t i = 1; i < run.t.size(); ++i) {
    const double step = run.t[i] - run.t[i - 1];
    if (step <= kGap * usual) continue;
    log.add({DataFaultKind::Gap, false, run.file, "", "", rowOf(i), inMs(step) + " without a row"});
    return;
  }
}

// The steps that a set or its robot's model states for an encoder; 0: none.
double findStatedQuantum(const LogJoint& joint, const RobotModel* model) {
  if (!std::isnan(joint.encoder_quantum)) return joint.encoder_quantum;
  if (model == nullptr || !model->findJoint(joint.name)) return 0;
  for (const EffectSetting& effect : model->effects) {
    const auto quantum = effect.parameters.find("quantum");
    if (effect.name == "encoder_quantum" && quantum != effect.parameters.end()) {
      return quantum->second;
    }
  }
  return 0;
}

// Whether row i repeats the one before although the joint goes on, one way, in the `window` rows on
// both sides of it.
bool isRepeated(const Column& q, std::size_t i, std::size_t window, double quantum, bool& moving) {
  constexpr double kSpeed = 3;   // steps per row: too fast to read the same twice
  constexpr double kFar = 0.02;  // [rad] 13 steps of a 12 bit encoder, where its step is not known
  const double least = std::max(kSpeed * static_cast<double>(window) * quantum, kFar);
  if (i < window + 1 || i + window >= q.size()) return false;
  const double before = q[i - 1] - q[i - 1 - window], after = q[i + window] - q[i];
  moving = std::abs(before) >= least && std::abs(after) >= least && before * after > 0;
  return moving && q[i] == q[i - 1];
}

double calcRange(const Column* values) {
  if (values == nullptr) return 0;
  double low = 1e300, high = -1e300;
  for (const double x : *values) {
    if (!std::isnan(x)) low = std::min(low, x), high = std::max(high, x);
  }
  return high > low ? high - low : 0;
}

bool isStiff(const LogRun& run, const std::string& joint) {
  const Column* stiffness = run.find("cmd_stiffness." + joint);
  if (stiffness == nullptr) return true;
  return std::all_of(stiffness->begin(), stiffness->end(),
                     [](double x) { return std::isnan(x) || x > 0.1; });
}

}  // namespace

void checkTimes(const LogSet& set, FaultLog& log) {
  for (const LogRun& run : set.runs) {
    checkOrder(run, log);
    checkSteps(set, run, log);
  }
}

Quanta findQuanta(const LogSet& set) {
  Quanta quanta;
  for (const LogJoint& joint : set.joints) {
    std::vector<double> seen;  // one per run: a zero may differ from run to run
    for (const LogRun& run : set.runs) {
      const Column* q = run.find("q." + joint.name);
      if (q != nullptr) seen.push_back(findQuantum(*q));
    }
    if (seen.empty()) continue;
    std::sort(seen.begin(), seen.end());
    quanta[joint.name] = seen[seen.size() / 2];
  }
  return quanta;
}

void checkQuanta(const LogSet& set, const RobotModel* model, const Quanta& quanta, FaultLog& log) {
  constexpr double kCoarser = 1.1;  // times what is stated
  for (const LogJoint& joint : set.joints) {
    const auto found = quanta.find(joint.name);
    if (found == quanta.end() || found->second == 0) continue;
    const double stated = findStatedQuantum(joint, model);
    const bool fault = stated > 0 && found->second > kCoarser * stated;
    std::string text = "angles come in steps of " + fixed(1000 * found->second, 4) + " mrad";
    if (fault) text += ", coarser than the stated " + fixed(1000 * stated, 4) + " mrad";
    log.add({DataFaultKind::Quantum, !fault, "", joint.name, "q", {}, text});
  }
}

void checkDuplicates(const LogSet& set, const Quanta& quanta, FaultLog& log) {
  constexpr double kPart = 0.005;    // of the rows in motion; below, a chance meeting
  constexpr std::size_t kLeast = 3;  // rows
  constexpr double kWindow = 0.04;   // [s] looked at on either side, and at least four rows
  const auto window = std::max<std::size_t>(4, static_cast<std::size_t>(kWindow * set.rate + 0.5));
  for (const LogJoint& joint : set.joints) {
    const auto quantum = quanta.find(joint.name);
    std::size_t all = 0, repeated = 0, row = 0;
    std::string file;
    for (const LogRun& run : set.runs) {
      const Column* q = run.find("q." + joint.name);
      for (std::size_t i = 1; q != nullptr && i < q->size(); ++i) {
        bool moving = false;
        const bool same = isRepeated(*q, i, window, quantum->second, moving);
        all += moving;
        repeated += same;
        if (same && file.empty()) file = run.file, row = rowOf(i);
      }
    }
    if (repeated < kLeast || static_cast<double>(repeated) < kPart * static_cast<double>(all)) {
      continue;
    }
    log.add({DataFaultKind::Duplicates, false, file, joint.name, "q", row,
             "the reading before is repeated while the joint moves, in " +
                 std::to_string(repeated) + " of " + std::to_string(all) +
                 " such rows of the set"});
  }
}

void checkConstants(const LogSet& set, FaultLog& log) {
  constexpr double kCommanded = 0.2;  // [rad] more than dry friction may hold
  constexpr double kMoved = 0.05;     // [rad]
  for (const LogRun& run : set.runs) {
    for (const LogJoint& joint : set.joints) {
      const double moved = calcRange(run.find("q." + joint.name));
      const bool told = calcRange(run.find("cmd." + joint.name)) > kCommanded;
      if (run.find("q." + joint.name) && moved == 0 && told && isStiff(run, joint.name)) {
        log.add({DataFaultKind::Constant,
                 false,
                 run.file,
                 joint.name,
                 "q",
                 {},
                 "the reading stands still while the command moves"});
      }
      for (const char* signal : {"qd", "cur", "tau"}) {
        const Column* channel = run.find(std::string(signal) + "." + joint.name);
        if (channel == nullptr || moved < kMoved || calcRange(channel) > 0) continue;
        log.add({DataFaultKind::Constant,
                 false,
                 run.file,
                 joint.name,
                 signal,
                 {},
                 "the reading stands still while the joint moves"});
      }
    }
  }
}

}  // namespace nao::validation
