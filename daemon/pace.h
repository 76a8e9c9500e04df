#pragma once

#include <chrono>

#include "core/sim_time.h"

namespace nao::daemon {

/// Decides when simulated time may go on, never what happens in it. A host that is too slow lowers
/// the speed: lost time is not caught up.
class Pace {
 public:
  using Wall = std::chrono::steady_clock::time_point;

  /// `speed` [simulated s per s]; infinite: never wait.
  Pace(double speed, SimTime now, Wall wall) : speed_(speed), from_(now), wall_(wall) {}

  double speed() const { return speed_; }

  /// From here on with this speed; also after a pause.
  void restart(double speed, SimTime now, Wall wall) { *this = Pace(speed, now, wall); }

  /// When the simulation, now at `time`, may go on. At or before `wall`: at once.
  Wall due(SimTime time, Wall wall);

 private:
  double speed_;
  SimTime from_;
  Wall wall_;
};

}  // namespace nao::daemon
