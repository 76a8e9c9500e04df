#pragma once

#include <string>

#include "validation/log/robot_log.h"

namespace nao::validation {

/// @throws InputError if `folder` holds a set already: what was recorded once is not written over.
void requireNoSet(const std::string& folder);

/// A set that is written run by run as it is recorded: after every add() the folder holds a whole
/// set of the runs so far, whatever becomes of the rest.
class GrowingSet {
 public:
  /// `set`: everything but runs. Creates the folder. @throws InputError if it can not be made or
  /// holds a set already.
  GrowingSet(LogSet set, std::string folder);

  /// Writes the run's rows, then the list of runs with it. @throws InputError if a file can not be
  /// written; the set is then as it was.
  void add(LogRun run);

  /// Without the rows, which are on disk.
  const LogSet& set() const { return set_; }

 private:
  LogSet set_;
  std::string folder_;
};

}  // namespace nao::validation
