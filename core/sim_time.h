#pragma once

#include <chrono>

namespace nao {

using Duration = std::chrono::nanoseconds;

/// Simulated time since the start of the world. It has no now(): only the simulation advances it,
/// so simulated and wall time can not be mixed by accident.
struct SimClock {
  using duration = Duration;
  using rep = duration::rep;
  using period = duration::period;
  using time_point = std::chrono::time_point<SimClock>;
  static constexpr bool is_steady = true;  // NOLINT: named by std::chrono
};
using SimTime = SimClock::time_point;

/// `duration` as a real number of seconds, for formulas.
constexpr double toSeconds(Duration duration) {
  return std::chrono::duration<double>(duration).count();
}

/// The seconds from the start of the world to `time`.
constexpr double toSeconds(SimTime time) { return toSeconds(time.time_since_epoch()); }

/// `seconds` rounded to the nearest nanosecond, for numbers that come from files and clients.
constexpr Duration fromSeconds(double seconds) {
  return Duration(static_cast<Duration::rep>(seconds * 1e9 + (seconds < 0 ? -0.5 : 0.5)));
}

}  // namespace nao
