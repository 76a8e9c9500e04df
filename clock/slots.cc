#include <pthread.h>
#include <sys/types.h>
#include <unistd.h>

#include "clock/futex.h"
#include "clock/links.h"
#include "clock/registry.h"
#include "clock/turn.h"

namespace nao::clock {
namespace {

thread_local Slot* for_child __attribute__((tls_model("initial-exec"))) = nullptr;

std::int32_t self() { return static_cast<std::int32_t>(rawCall(SYS_getpid, 0, 0, 0, 0)); }

// Made by our parent for whom it was about to start.
Slot* slotOfUnborn(ClockPage& page) {
  const Registry registry(page);
  for (std::uint32_t i = 0; i < page.slots_used.load(); ++i) {
    Slot& slot = page.slots[i];
    std::int32_t unborn = -static_cast<std::int32_t>(::getppid());
    if (slot.state.load() == SlotState::Ready &&
        slot.process.compare_exchange_strong(unborn, self()))
      return &slot;
  }
  return nullptr;
}

// What the same process left when it became another program; its first thread goes on.
Slot* slotBefore(ClockPage& page) {
  Slot* kept = nullptr;
  const Registry registry(page);
  for (std::uint32_t i = 0; i < page.slots_used.load(); ++i) {
    Slot& slot = page.slots[i];
    if (slot.process.load() != self() || slot.state.load() == SlotState::Free) continue;
    const bool has_turn = page.holder.load() == i;
    if (!kept || has_turn) {
      if (kept) kept->state = SlotState::Free;
      kept = &slot;
    } else {
      slot.state = SlotState::Free;
    }
  }
  return kept;
}

void beforeFork() {
  if (taker()) for_child = makeSlot();
}

void inParent() { for_child = nullptr; }

void inChild() {
  Slot* slot = for_child;
  for_child = nullptr;
  if (slot) begin(*slot);
}

__attribute__((constructor)) void enter() {
  ClockPage* at = page();
  if (!at || at->mode != Mode::Lockstep) return;
  ::pthread_atfork(beforeFork, inParent, inChild);
  Slot* slot = slotBefore(*at);
  if (!slot) slot = slotOfUnborn(*at);
  if (!slot) slot = makeSlot();
  if (!slot) return;
  slot->handle = static_cast<std::uint64_t>(::pthread_self());
  if (at->holder.load() != static_cast<std::uint32_t>(slot - at->slots))
    slot->state = SlotState::Ready;
  begin(*slot);
}

}  // namespace

Slot* makeSlot() {
  Slot* slot = takeSlot(*page(), self());
  if (!slot) page()->strayed.fetch_add(1);
  return slot;
}

void dropSlot(Slot& slot) { slot.state = SlotState::Free; }

Slot* findThread(std::uint64_t handle) {
  ClockPage& at = *page();
  Slot* found = nullptr;
  for (std::uint32_t i = 0; i < at.slots_used.load(); ++i) {
    Slot& slot = at.slots[i];
    if (slot.process.load() != self() || slot.handle != handle) continue;
    if (slot.state.load() == SlotState::Free) continue;
    if (!found || slot.order > found->order) found = &slot;
  }
  return found;
}

bool anyBeside() {
  ClockPage& at = *page();
  for (std::uint32_t i = 0; i < at.slots_used.load(); ++i) {
    const Slot& slot = at.slots[i];
    if (slot.process.load() == self() && slot.state.load() == SlotState::Beside) return true;
  }
  return false;
}

void leaveProcess() {
  ClockPage* at = page();
  if (!at || at->mode != Mode::Lockstep) return;
  const std::int32_t process = self();
  closeLinks();
  Slot* own = leaveTurns();
  for (std::uint32_t i = 0; i < at->slots_used.load(); ++i) {
    Slot& slot = at->slots[i];
    if (slot.process.load() == process && &slot != own) slot.state = SlotState::Free;
  }
  if (own) giveUp(*own);
}

__attribute__((destructor)) void leaveAtExit() { leaveProcess(); }

}  // namespace nao::clock
