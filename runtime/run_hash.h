#pragma once

#include "core/archive.h"
#include "runtime/simulation_watcher.h"

namespace nao::runtime {

/// One number for a whole run: the states every 100 ms of simulated time, and all inputs with their
/// simulated times in their order. Two runs that share it went alike; which process, port or
/// message brought an input is no part of it.
class RunHash final : public SimulationWatcher {
 public:
  static constexpr Duration kEvery = std::chrono::milliseconds(100);

  void took(const Input& input) override;
  void stepped(const Simulation& simulation) override;

  /// Of the run so far.
  std::uint64_t value() const { return hash_.hash(); }

 private:
  Archive hash_ = Archive::hashing();
};

}  // namespace nao::runtime
