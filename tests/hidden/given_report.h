#pragma once

#include <string>
#include <utility>
#include <vector>

#include "validation/diagnosis/causes/verdict.h"

namespace nao::hidden {

/// A cause that a report names, or one of those it cannot tell apart.
struct GivenCause {
  std::string cause, effect;
  std::string joint;  // empty: all joints
  std::vector<std::string> rivals;
  double gain = 0;  // [nats]
  bool has_number = false;
  std::string parameter;
  double value = 0, deviation = 0, low = 0, high = 0;
  /// Of the further parameters that shape it.
  std::vector<std::pair<std::string, double>> shape;
  validation::StatementKind kind{};  // of an old report: empty
};

/// What a diagnosis wrote of one joint.
struct GivenJoint {
  std::string joint, verdict, signature;
  validation::StatementKind kind{};  // empty where a cause is named
};

/// The part of report.json that is judged.
struct GivenReport {
  std::string verdict;                  // of the set
  std::vector<GivenCause> causes;       // that are of interest, the one that explains most first
  std::vector<GivenCause> adjustments;  // what is told beside them, too small to be a cause
  std::vector<GivenJoint> joints;
  std::vector<std::string> faults;  // of the data, by kind: "swapped", "clock" ...

  bool remains(const std::string& joint) const;  // something unexplained is left at this joint
};

/// @throws InputError if this is no report of a diagnosis.
GivenReport readReport(const std::string& json);

/// The kinds of data faults in what `diagnose` or `check-data` printed, notes left out.
std::vector<std::string> readFaults(const std::string& printed);

}  // namespace nao::hidden
