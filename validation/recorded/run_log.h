#pragma once

#include "runtime/replayer.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// From when to when something is asked of a run: simulated time since its start.
struct Stretch {
  Duration from{};
  Duration to = Duration::max();
};

/// Writes down, cycle by cycle, what one robot of a replayed run was told and sensed. To be made
/// before the replay begins; the replayer outlives it.
class RunLog {
 public:
  RunLog(runtime::Replayer& replayer, std::size_t robot, Stretch stretch);
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;

  /// The rows at the times of the recorded run [s].
  const LogRun& run() const { return run_; }
  /// All of it as a set of one run.
  LogSet set(const std::string& source) const;

 private:
  void add(const SensorFrame& sensors, const JointCommand& command);

  runtime::Replayer& replayer_;
  std::size_t robot_;
  Stretch stretch_;
  LogRun run_;
};

/// One run's rows as CSV. @throws InputError if the file can not be written.
void writeRows(const LogRun& run, const std::string& file);

}  // namespace nao::validation
