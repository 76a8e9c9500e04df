#pragma once

#include <functional>
#include <map>
#include <utility>

#include "core/sim_time.h"

namespace nao::test {

/// Simulated time that a test moves by hand, with timers as RobotLink has them.
class ManualClock {
 public:
  Duration now() const { return now_; }

  void callLater(Duration delay, std::function<void()> then) {
    timers_.emplace(now_ + delay, std::move(then));
  }

  /// Moves on and calls what falls due, in order, at its own time.
  void advance(Duration by) {
    const Duration end = now_ + by;
    while (!timers_.empty() && timers_.begin()->first <= end) {
      auto timer = timers_.extract(timers_.begin());
      now_ = timer.key();
      timer.mapped()();
    }
    now_ = end;
  }

 private:
  Duration now_{};
  std::multimap<Duration, std::function<void()>> timers_;
};

}  // namespace nao::test
