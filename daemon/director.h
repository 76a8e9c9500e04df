#pragma once

#include "core/sim_time.h"
#include "daemon/robot_loop.h"

namespace nao::daemon {

/// Follows a world from inside and acts in it, as a scenario does. At every beat, and once before
/// the first, time stands until the services have taken in what the robots felt (look()) and
/// waits() says no; then direct() is called and time goes on.
class Director {
 public:
  virtual ~Director() = default;

  /// I/O thread: the services are up to date with the world as it is in `state`. True if this may
  /// let time go on.
  virtual bool look(const LoopState& state) = 0;

  /// Simulation thread; must not block.
  virtual bool waits(SimTime now) = 0;

  /// Simulation thread, at the beginning of a beat: may apply requests. Nothing may throw.
  virtual void direct(runtime::Simulation& simulation) = 0;
};

}  // namespace nao::daemon
