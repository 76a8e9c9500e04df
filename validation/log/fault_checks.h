#pragma once

#include <map>
#include <string>
#include <vector>

#include "validation/log/data_faults.h"

// The single checks of data_faults.h, and where they put what they find.
namespace nao::validation {

/// Collects findings: what several runs or nearly all joints show alike becomes one.
class FaultLog {
 public:
  struct Entry {
    DataFaultKind kind{};
    bool note = false;
    std::string file;    // empty: the set
    std::string joint;   // empty: none in particular
    std::string signal;  // "q"; empty: the joint as such
    std::optional<std::size_t> row;
    std::string text;  // after "file: row: column: "
  };
  void add(Entry entry) { entries_.push_back(std::move(entry)); }
  void append(const FaultLog& other) {
    entries_.insert(entries_.end(), other.entries_.begin(), other.entries_.end());
  }
  bool empty() const { return entries_.empty(); }
  /// `joints`: how many the set has.
  std::vector<DataFault> merge(std::size_t joints) const;

 private:
  std::vector<Entry> entries_;
};

/// The steps of every joint's encoder [rad], as the data show them; 0: none seen.
using Quanta = std::map<std::string, double>;
Quanta findQuanta(const LogSet& set);

/// One joint of a run on an even grid; empty where it was not sampled.
struct JointSeries {
  std::vector<double> command;  // [rad]
  std::vector<double> sensor;   // [rad]
  std::vector<bool> stiff;      // the motor is on; empty: always
};
/// By run, then joint in the order of the set.
using SetSeries = std::vector<std::vector<JointSeries>>;
SetSeries resampleAll(const LogSet& set, double dt);

void checkTimes(const LogSet& set, FaultLog& log);
void checkDuplicates(const LogSet& set, const Quanta& quanta, FaultLog& log);
void checkQuanta(const LogSet& set, const RobotModel* model, const Quanta& quanta, FaultLog& log);
void checkConstants(const LogSet& set, FaultLog& log);
void checkUnits(const LogSet& set, const RobotModel* model, FaultLog& log);
void checkJointMap(const LogSet& set, const SetSeries& series, double dt, FaultLog& log);
void checkOffsets(const LogSet& set, const SetSeries& series, double dt, FaultLog& log);
void checkRepeats(const LogSet& set, const SetSeries& series, double dt, FaultLog& log);
void checkCopies(const LogSet& set, FaultLog& log);
void checkSplits(const LogSet& set, FaultLog& log);

}  // namespace nao::validation
