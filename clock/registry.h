#pragma once

#include "clock/clock_page.h"
#include "clock/futex.h"

namespace nao::clock {

/// Alone with the lists of slots and links. Who died in here is not waited for.
class Registry {
 public:
  explicit Registry(ClockPage& page) : page_(page) {
    for (int i = 0; i < 100000; ++i) {
      std::uint32_t open = 0;
      if (page_.registry_lock.compare_exchange_weak(open, 1)) return;
      rawCall(SYS_sched_yield, 0, 0, 0, 0);
    }
  }
  ~Registry() { page_.registry_lock = 0; }
  Registry(const Registry&) = delete;
  Registry& operator=(const Registry&) = delete;

 private:
  ClockPage& page_;
};

}  // namespace nao::clock
