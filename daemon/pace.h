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

  /// Late by more than this, time is lost; by less, it is caught up. 100 ms until told otherwise.
  void setPatience(std::chrono::nanoseconds patience) { patience_ = patience; }

  double speed() const { return speed_; }

  /// From here on with this speed; also after a pause.
  void restart(double speed, SimTime now, Wall wall) {
    speed_ = speed;
    from_ = now;
    wall_ = wall;
  }

  /// When the simulation, now at `time`, may go on. At or before `wall`: at once.
  Wall due(SimTime time, Wall wall);

 private:
  double speed_;
  SimTime from_;
  Wall wall_;
  std::chrono::nanoseconds patience_ = std::chrono::milliseconds(100);
};

}  // namespace nao::daemon
