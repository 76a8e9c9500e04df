#pragma once

#include "runtime/input.h"

namespace nao::runtime {

class Simulation;

/// Looks on while a simulation runs, on its thread, without changing anything.
class SimulationWatcher {
 public:
  virtual ~SimulationWatcher() = default;

  /// An input as it is taken over; a world request once it has been carried out.
  virtual void took(const Input& input) = 0;

  /// After every step.
  virtual void stepped(const Simulation& simulation) = 0;
};

}  // namespace nao::runtime
