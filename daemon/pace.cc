#include "daemon/pace.h"

#include <algorithm>
#include <cmath>

namespace nao::daemon {
namespace {

constexpr double kForever = 1e9;  // [s] any later is beyond the clock's range

}  // namespace

Pace::Wall Pace::due(SimTime time, Wall wall) {
  if (std::isinf(speed_)) return wall;
  const Wall due = wall_ + fromSeconds(std::min(toSeconds(time - from_) / speed_, kForever));
  if (wall - due > patience_) restart(speed_, time, wall);
  return due;
}

}  // namespace nao::daemon
