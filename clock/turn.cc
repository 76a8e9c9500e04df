#include "clock/turn.h"

#include <csignal>

#include "clock/futex.h"
#include "clock/links.h"
#include "clock/real.h"

namespace nao::clock {
namespace {

constexpr std::uint32_t kMostPasses = 1000;  // without the world; each further one takes kLookCost
// In place of kFreeLooks before anybody has waited: Python reads clocks a dozen times per import.
constexpr std::uint32_t kFirstLooks = 100000;
constexpr std::int64_t kWatch = 100 * kMillisecond;  // how often a waiting thread looks up

thread_local Slot* own __attribute__((tls_model("initial-exec"))) = nullptr;
thread_local int inside __attribute__((tls_model("initial-exec"))) = 0;
thread_local std::uint32_t looks __attribute__((tls_model("initial-exec"))) = 0;

/// What happens in here is not the program's: a signal's handler that comes meanwhile, and what we
/// call ourselves, find the C library as it is.
struct Inside {
  Inside() { ++inside; }
  ~Inside() { --inside; }
  Inside(const Inside&) = delete;
  Inside& operator=(const Inside&) = delete;
};

std::uint32_t numberOf(const Slot& slot) {
  return static_cast<std::uint32_t>(&slot - page()->slots);
}

bool has(const Slot& slot) { return page()->holder.load() == numberOf(slot); }

void give(ClockPage& page, std::uint32_t from, std::uint32_t next) {
  if (!page.holder.compare_exchange_strong(from, next)) return;  // it was taken from us
  page.passes.fetch_add(1);
  if (next == from) return;
  ring(next == kWorld ? page.world_bell : page.slots[next].bell);
}

// The turn goes to whoever is next, which may be us.
void pass(Slot& slot) {
  ClockPage& at = *page();
  if (!has(slot)) return;
  at.began = 1;
  at.round = slot.order;
  if (++at.passes_since_world > kMostPasses) at.now.fetch_add(kLookCost);
  give(at, numberOf(slot), nextHolder(at));
}

// Whether a signal came meanwhile.
bool awaitTurn(Slot& slot) {
  bool interrupted = false;
  while (!has(slot) && page()->stopped.load() == 0) {
    const std::uint32_t bell = slot.bell.load();
    if (has(slot)) break;
    if (waitWhile(slot.bell, bell, kWatch) != -EINTR) continue;
    interrupted = true;
    slot.state = SlotState::Ready;
  }
  return interrupted;
}

void run(Slot& slot) {
  slot.state = SlotState::Running;
  page()->happened.fetch_add(1);
}

bool raiseAlarm(Slot& slot) {
  const std::int64_t now = page()->now.load();
  if (slot.alarm > now) return false;
  slot.alarm = slot.alarm_interval > 0 ? now + slot.alarm_interval : kNever;
  const int depth = inside;
  inside = 0;
  ::raise(SIGALRM);
  inside = depth;
  return true;
}

// In a state that says what for, until the turn is ours again.
bool waitForTurn(Slot& slot, SlotState state) {
  slot.state = state;
  pass(slot);
  const bool interrupted = awaitTurn(slot);
  return interrupted || raiseAlarm(slot);
}

void regain(Slot& slot) {
  if (has(slot)) return;
  const Inside guard;
  slot.state = SlotState::Ready;
  awaitTurn(slot);
  run(slot);
}

Woken follow(Waiting& waiting, std::int64_t deadline) {
  for (;;) {
    if (waiting.isThere()) return Woken::Ready;
    if (pageNow() >= deadline) return Woken::Late;
    errno = 0;
    const std::int64_t rest = deadline == kNever ? kSecond : realSpan(deadline - pageNow());
    if (waiting.block(rest)) return Woken::Ready;
    if (errno == EINTR) return Woken::Interrupted;
  }
}

class Nothing final : public Waiting {
 public:
  bool isThere() override { return false; }
  bool block(std::int64_t real) override {
    const timespec time = toTimespec(real);
    const long result =
        rawCall(SYS_clock_nanosleep, CLOCK_MONOTONIC, 0, reinterpret_cast<long>(&time), 0);
    errno = result == -EINTR ? EINTR : 0;
    return false;
  }
};

Woken queueUp(Slot& slot, std::int64_t deadline) {
  slot.deadline = deadline;
  bool interrupted = false;
  while (!slot.signalled && page()->now.load() < deadline && !interrupted &&
         page()->stopped.load() == 0) {
    interrupted = waitForTurn(slot, SlotState::Queued);
  }
  slot.queue = 0;
  run(slot);
  if (slot.signalled) return Woken::Ready;
  return interrupted ? Woken::Interrupted : Woken::Late;
}

}  // namespace

void yieldTurn() {
  Slot* slot = taker();
  if (!slot) return;
  look();
  const Inside guard;
  waitForTurn(*slot, SlotState::Ready);
  run(*slot);
}

void letOthers() {
  Slot* slot = taker();
  if (!slot) return;
  const Inside guard;
  slot->deadline = kNever;
  slot->looked = page()->happened.load();
  waitForTurn(*slot, SlotState::Trying);
  slot->state = SlotState::Running;
}

Slot* leaveTurns() {
  Slot* slot = own;
  own = nullptr;
  return slot;
}

void giveUp(Slot& slot) {
  page()->round = slot.order;
  slot.state = SlotState::Leaving;
  if (has(slot)) give(*page(), numberOf(slot), kWorld);
}

Slot* taker() {
  if (!own || inside || page()->stopped.load() != 0) return nullptr;
  regain(*own);
  return own;
}

void look() {
  Slot* slot = taker();
  if (!slot || ++looks <= (page()->began.load() == 0 ? kFirstLooks : kFreeLooks)) return;
  const Inside guard;
  if (page()->now.fetch_add(kLookCost) + kLookCost < page()->world_due.load()) return;
  waitForTurn(*slot, SlotState::Ready);
  run(*slot);
}

Woken waitFor(Waiting& waiting, std::int64_t deadline) {
  Slot* slot = taker();
  if (!slot) return follow(waiting, deadline);
  const Inside guard;
  for (bool waited = false;; waited = true) {
    settleLinks();
    if (waiting.isThere()) break;
    if (page()->now.load() >= deadline) {
      if (waited) run(*slot);
      return Woken::Late;
    }
    looks = 0;
    slot->deadline = deadline;
    slot->looked = page()->happened.load();
    if (waitForTurn(*slot, SlotState::Trying)) {
      if (waiting.isThere()) break;  // asked once: what it is may be taken by asking
      run(*slot);
      return Woken::Interrupted;
    }
    if (page()->stopped.load() != 0) return follow(waiting, deadline);
  }
  run(*slot);
  return Woken::Ready;
}

Woken sleepUntil(std::int64_t deadline) {
  Slot* slot = taker();
  Nothing nothing;
  if (!slot) return follow(nothing, deadline);
  const Inside guard;
  looks = 0;
  slot->signalled = 0;
  slot->queue = 0;
  const Woken woken = queueUp(*slot, deadline);
  return page()->stopped.load() != 0 ? follow(nothing, deadline) : woken;
}

void enterQueue(const void* queue) {
  own->signalled = 0;
  own->queue = reinterpret_cast<std::uint64_t>(queue);
  own->ticket = ++page()->last_ticket;
}

Woken waitInQueue(std::int64_t deadline) {
  const Inside guard;
  looks = 0;
  return queueUp(*own, deadline);
}

int signalQueue(const void* queue, bool all) {
  ClockPage& at = *page();
  const std::int32_t process = own->process.load();
  int found = 0;
  for (;;) {
    Slot* first = nullptr;
    for (std::uint32_t i = 0; i < at.slots_used.load(); ++i) {
      Slot& slot = at.slots[i];
      if (slot.process.load() != process || slot.signalled ||
          slot.queue != reinterpret_cast<std::uint64_t>(queue))
        continue;
      if (!first || slot.ticket < first->ticket) first = &slot;
    }
    if (!first) return found;
    first->signalled = 1;
    ++found;
    if (!all) return found;
  }
}

void begin(Slot& slot) {
  own = &slot;
  slot.thread = static_cast<std::int32_t>(rawCall(SYS_gettid, 0, 0, 0, 0));
  slot.process = static_cast<std::int32_t>(rawCall(SYS_getpid, 0, 0, 0, 0));
  const Inside guard;
  awaitTurn(slot);
  run(slot);
}

void end() {
  Slot* slot = own;
  if (!slot) return;
  const Inside guard;
  regain(*slot);
  slot->state = slot->detached ? SlotState::Free : SlotState::Ended;
  slot->queue = 0;
  slot->alarm = kNever;
  page()->happened.fetch_add(1);
  own = nullptr;
  pass(*slot);
}

}  // namespace nao::clock
