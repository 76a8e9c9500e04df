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

/// A slot for a thread of this process that is to begin, after all that there are; null: all are
/// taken. A parent that is about to start a program says -(its own number) and, once there is one,
/// the child's: the child finds it by either.
inline Slot* takeSlot(ClockPage& page, std::int32_t process) {
  const Registry registry(page);
  Slot* slot = nullptr;
  for (Slot& other : page.slots) {
    const SlotState state = other.state.load();
    if (state == SlotState::Free) slot = &other;
    if (state == SlotState::Free) break;
    if (state == SlotState::Ended && (!slot || other.order < slot->order)) slot = &other;
  }
  if (!slot) return nullptr;
  const auto number = static_cast<std::uint32_t>(slot - page.slots);
  slot->process = process;
  slot->thread = 0;
  slot->order = ++page.last_order;
  slot->deadline = slot->alarm = kNever;
  slot->alarm_interval = 0;
  slot->handle = slot->queue = slot->ticket = slot->looked = 0;
  slot->signalled = slot->detached = 0;
  if (number >= page.slots_used.load()) page.slots_used = number + 1;
  slot->state = SlotState::Ready;
  return slot;
}

}  // namespace nao::clock
