#pragma once

#include <chrono>
#include <cstddef>

#include "bench/wire_server.h"

namespace nao::bench {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start);

/// Processor time that a process has used [s].
double processorTime(pid_t process);

/// What the daemon does from its making on: its processor time, and how late its cycles are.
class ServerWatch {
 public:
  explicit ServerWatch(const WireServer& server);

  double cpuPercent() const;
  double latenessP99Ms() const;

 private:
  const WireServer& server_;
  Clock::time_point start_;
  double processor_s_;
  std::size_t cycles_;
};

}  // namespace nao::bench
