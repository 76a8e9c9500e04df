#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/recording.h"
#include "runtime/simulation_watcher.h"

namespace nao::runtime {

/// Writes a run down while it goes: what it began with, every input, and the hash of its state
/// every 100 ms. What it has written it commits every 0.8 s of simulated time, without waiting for
/// the disk: when this program is killed at any moment the file opens and lacks that much at most.
/// While it writes nobody else opens the file. On the simulation's thread, whose watcher it is to
/// be from the start.
class Recorder final : public SimulationWatcher {
 public:
  /// Takes the place of a recording of this name. @throws InputError if the file can not be
  /// written, or is something else.
  Recorder(const std::string& file, const RunStart& start);
  ~Recorder() override;

  void took(const Input& input) override;
  void stepped(const Simulation& simulation) override;

  /// The run is over: its last state. Others may open the file.
  void finish(const Simulation& simulation);

  /// One sentence if writing failed under way (a full disk), from when on nothing is recorded.
  const std::string& failure() const { return failure_; }

 private:
  struct Pending;

  void addState(const Simulation& simulation);
  void commit();

  std::string failure_;
  std::unique_ptr<Pending> pending_;
  std::size_t inputs_ = 0;
  Duration elapsed_{};
  Duration committed_{};
};

}  // namespace nao::runtime
