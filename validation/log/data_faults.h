#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"
#include "validation/report.h"

namespace nao::validation {

/// What can be wrong with data themselves, before anything is simulated.
enum class DataFaultKind {
  Clock,       // times do not rise
  Gap,         // rows are missing
  Rate,        // rows come irregularly, or not at the rate that the set states
  Duplicates,  // readings are repeated while the joint moves
  Quantum,     // angles in coarser steps than the encoder's
  Offset,      // command and sensor streams are shifted against each other
  Swapped,     // a sensor follows another joint's command
  Negated,     // a sensor moves against its command
  Unrelated,   // a sensor follows no command at all
  Units,       // degrees for radians
  Constant,    // a channel stands still while its joint is moved
  Misaligned,  // repeats do not begin at the same command, or are no repeats
  Copied,      // two runs hold the same readings
  Split,       // one motion is used for several purposes
};

/// As it is called in reports, such as "duplicates".
const char* nameOf(DataFaultKind kind);

/// One finding. `column` is a signal of one joint, or a joint; empty: all of them.
struct DataFault {
  DataFaultKind kind{};
  bool note = false;  // worth knowing, yet nothing is wrong: an encoder's step as stated
  std::string file;   // the first run that shows it; empty: the set
  std::string column;
  std::optional<std::size_t> row;  // as an editor counts, the header is 1
  std::string sentence;            // says it all, for people
};

/// Everything wrong with the data of a set; `model`, which may be null, tells ranges and the
/// encoder's step where the set does not. A cause of a poor simulation is none: joints that lag,
/// stick, stop early or follow weakly pass.
std::vector<DataFault> findDataFaults(const LogSet& set, const RobotModel* model);

/// Whether any finding is more than a note.
bool anyFault(const std::vector<DataFault>& findings);

/// Whether a diagnosis by joints names it itself: coarse steps of one encoder, a cause like others
/// (encoder_quantum) that may stand beside others; those of all joints are the recording's.
bool isOneCoarseEncoder(const DataFault& fault);

/// For `usarnaoqi check-data`.
Report reportDataFaults(const LogSet& set, const std::vector<DataFault>& findings);

}  // namespace nao::validation
