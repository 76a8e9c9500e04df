#pragma once

#include <string>

#include "tests/hidden/given_report.h"
#include "tests/hidden/hidden_case.h"

namespace nao::hidden {

/// How a diagnosis did on one set, in the words of the figures.
struct Score {
  // Nulls.
  bool false_alarm = false;  // anything named or ambiguous anywhere
  bool said_unknown = false;
  // Singles, weak or not.
  bool detected = false;     // anything but "no discrepancy" or "unfinished"
  bool exact = false;        // the first cause is the truth
  bool look_alike = false;   // the first cause is one that the truth lists as looking the same
  bool named_wrong = false;  // a cause that is neither, named alone
  bool truth_in_set = false;
  bool ambiguous = false, unknown = false;
  int set_size = 0;  // of the first cause and its rivals; 0: nothing was named
  // Pairs.
  int found = 0;                   // of the hidden ones
  int found_among = 0;             // so, or as rivals, or by look-alikes listed beforehand
  int named = 0, named_right = 0;  // look-alikes are neither
  // Strangers.
  bool flagged = false;  // unknown, or partly explained with no cause named alone
  bool signature_right = false;
  // Data faults.
  bool fault_found = false, fault_named = false;  // any; the right kind
  // Numbers of the causes that are right, where their parameters mean the same.
  struct Number {
    double error = 0;  // relative to the hidden deviation
    bool has_interval = false, covered = false;
    bool own_law = true;  // hidden by the catalogue's law, not by one of another form
  };
  std::vector<Number> numbers;
};

Score score(const Truth& truth, const GivenReport& report);

/// A statement of a report: of a cause, or that there is nothing to name at a joint. Neither right
/// nor wrong is a cause that the truth lists as looking the same.
struct JudgedStatement {
  validation::StatementKind kind;
  bool right = false, wrong = false;
};
std::vector<JudgedStatement> judgeStatements(const Truth& truth, const GivenReport& report);

}  // namespace nao::hidden
