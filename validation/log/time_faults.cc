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

// Rows count from the begin of the motion.
void checkBegin(const LogRun& run, FaultLog& log) {
  constexpr double kLate = 0.25;  // [s] free choice
  if (run.t.empty() || std::abs(run.t.front()) <= kLate) return;
  log.add({DataFaultKind::Clock, false, run.file, "", "", rowOf(0),
           "the time begins at " + fixed(run.t.front(), 3) + " s, not with the motion"});
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

// Rows of one joint in which it moves, and those of them that repeat a reading. A joint that pauses
// slows down and sets off again; one whose reading is repeated stops from full speed and then
// jumps.
class RepeatFinder {
 public:
  RepeatFinder(const Column& q, std::size_t window, double quantum)
      : q_(q),
        window_(window),
        least_(std::max(kSpeed * static_cast<double>(window) * quantum, kFar)) {}

  // On both sides of row i, one way, too fast to read the same twice.
  bool moves(std::size_t i) const {
    if (i < window_ + 1 || i + window_ >= q_.size()) return false;
    const double before = q_[i - 1] - q_[i - 1 - window_], after = q_[i + window_] - q_[i];
    return std::abs(before) >= least_ && std::abs(after) >= least_ && before * after > 0;
  }

  // How many rows from i on repeat row i - 1, if i is the first that does; else 0.
  std::size_t countRepeats(std::size_t i) const {
    constexpr double kFullSpeed = 0.8;            // of the mean speed about row i, at least
    constexpr double kShort = 0.65, kLong = 1.4;  // of what the joint went on by meanwhile
    if (i < 2 || q_[i] != q_[i - 1] || q_[i - 1] == q_[i - 2] || !moves(i)) return 0;
    std::size_t last = i;
    while (last + 1 < q_.size() && q_[last + 1] == q_[i]) ++last;
    if (last + 1 >= q_.size()) return 0;
    const double rows = static_cast<double>(2 * window_ + 1);
    const double mean = (q_[i + window_] - q_[i - 1 - window_]) / rows;
    const double count = static_cast<double>(last - i + 1);
    const double stop = (q_[i - 1] - q_[i - 2]) / mean;
    const double jump = (q_[last + 1] - q_[last]) / mean / (count + 1);
    return stop > kFullSpeed && jump > kShort && jump < kLong ? last - i + 1 : 0;
  }

 private:
  static constexpr double kSpeed = 3;   // steps of the encoder per row
  static constexpr double kFar = 0.02;  // [rad] 13 steps of 12 bit, where the step is not known
  const Column& q_;
  std::size_t window_;
  double least_;
};

std::size_t calcWindow(const LogSet& set) {
  constexpr double kWindow = 0.04;  // [s] looked at on either side, and at least four rows
  return std::max<std::size_t>(4, static_cast<std::size_t>(kWindow * set.rate + 0.5));
}

// Rows that did not arrive: every joint in motion repeats its reading at once. Rare ones show too,
// because nothing else does that to several joints.
bool checkWholeRows(const LogSet& set, const Quanta& quanta, FaultLog& log) {
  constexpr int kSeveral = 4;        // joints in motion that a row must have to tell anything
  constexpr double kPart = 0.0016;   // of such rows; held commands give 0.1 %
  constexpr std::size_t kLeast = 3;  // rows
  std::size_t all = 0, repeated = 0, row = 0;
  std::string file;
  for (const LogRun& run : set.runs) {
    std::vector<int> moving(run.t.size(), 0), repeats(run.t.size(), 0);
    for (const LogJoint& joint : set.joints) {
      const Column* q = run.find("q." + joint.name);
      if (!q) continue;
      const RepeatFinder finder(*q, calcWindow(set), quanta.at(joint.name));
      for (std::size_t i = 1; i < q->size(); ++i) {
        moving[i] += finder.moves(i);
        repeats[i] += finder.moves(i) && (*q)[i] == (*q)[i - 1];
      }
    }
    for (std::size_t i = 1; i < run.t.size(); ++i) {
      if (moving[i] < kSeveral) continue;
      ++all;
      if (repeats[i] < moving[i]) continue;
      if (repeated++ == 0) file = run.file, row = rowOf(i);
    }
  }
  const bool fault =
      repeated >= kLeast && static_cast<double>(repeated) >= kPart * static_cast<double>(all);
  if (!fault) return false;
  log.add({DataFaultKind::Duplicates, false, file, "", "", row,
           "all joints in motion repeat the reading before, in " + std::to_string(repeated) +
               " of " + std::to_string(all) + " such rows of the set"});
  return true;
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
    checkBegin(run, log);
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
  if (checkWholeRows(set, quanta, log)) return;
  constexpr double kPart = 0.01;     // of the rows in motion; a staircase of commands gives 0.7 %
  constexpr std::size_t kLeast = 3;  // rows
  for (const LogJoint& joint : set.joints) {
    std::size_t all = 0, repeated = 0, row = 0;
    std::string file;
    for (const LogRun& run : set.runs) {
      const Column* q = run.find("q." + joint.name);
      if (!q) continue;
      const RepeatFinder finder(*q, calcWindow(set), quanta.at(joint.name));
      for (std::size_t i = 1; i < q->size(); ++i) {
        const std::size_t count = finder.countRepeats(i);
        all += finder.moves(i);
        repeated += count;
        if (count > 0 && file.empty()) file = run.file, row = rowOf(i);
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
