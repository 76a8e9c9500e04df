#pragma once

#include <memory>
#include <optional>

#include "runtime/recording.h"

namespace nao::runtime {

/// Does a recorded run again: the same start, and every input at its moment. Owns the simulation,
/// which nobody else may give inputs.
class Replayer final : private SimulationWatcher {
 public:
  /// `recording` outlives this. @throws InputError if its world can not be made.
  explicit Replayer(const Recording& recording) : Replayer(recording, recording.start) {}
  /// The inputs of a run on another start.
  Replayer(const Recording& recording, const RunStart& start);

  Simulation& simulation() { return simulation_; }

  /// Simulated time since the start, what was set back not subtracted.
  Duration elapsed() const { return elapsed_; }

  /// One step, with the inputs due before and in it. False at the end of the recording, or once
  /// the physics has diverged and nothing recorded sets it right.
  bool step();

  /// Steps to `elapsed`, or to the end.
  void advanceTo(Duration elapsed);

  /// At the end: carries out what was asked after the last step, and compares the last state.
  void finish();

  /// The first recorded state that this run did not have; none: all were the same to the last bit.
  const std::optional<Recording::State>& departure() const { return departure_; }
  /// How many recorded states were met again, until the first that was not.
  std::size_t statesMet() const { return met_; }

 private:
  void took(const Input&) override {}
  void stepped(const Simulation& simulation) override;
  void carryOut(const Recording::TimedInput& next);
  void takeInputs();
  void compare();
  bool isDue() const;

  const Recording& recording_;
  Simulation simulation_;
  Duration elapsed_{};
  std::size_t input_ = 0;  // the next one
  std::size_t state_ = 0;  // the next one
  std::size_t met_ = 0;
  std::optional<Recording::State> departure_;
};

}  // namespace nao::runtime
