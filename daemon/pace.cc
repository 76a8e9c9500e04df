#include "daemon/pace.h"

#include <cmath>

namespace nao::daemon {
namespace {

constexpr std::chrono::milliseconds kPatience{100};  // late by more: time is lost, not caught up

}  // namespace

Pace::Wall Pace::due(SimTime time, Wall wall) {
  if (std::isinf(speed_)) return wall;
  const Wall due = wall_ + fromSeconds(toSeconds(time - from_) / speed_);
  if (wall - due > kPatience) restart(speed_, time, wall);
  return due;
}

}  // namespace nao::daemon
