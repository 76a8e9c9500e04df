#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "sim/phase.h"

namespace nao::validation {

/// Adds up what the parts of a simulation cost: from begin() to the first ended(), and from there
/// to the next. Reads a steady clock, so what an interruption adds is left out.
class Profiler {
 public:
  Profiler();

  void begin() { last_ = Clock::now(); }
  void ended(sim::Phase phase) { add(static_cast<std::size_t>(phase)); }
  void endedMotion() { add(kMotion); }

  double seconds(sim::Phase phase) const { return seconds_[static_cast<std::size_t>(phase)]; }

  struct Part {
    std::string name;
    double seconds = 0;
  };
  /// All parts that took any time, in the order of a cycle.
  std::vector<Part> parts() const;

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::size_t kMotion = 31;  // beyond all phases
  void add(std::size_t part);

  Clock::time_point last_;
  double reading_ = 0;  // [s] what one look at the clock costs
  std::vector<double> seconds_;
};

}  // namespace nao::validation
