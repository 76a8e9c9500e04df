#include "daemon/world_turns.h"

#include <signal.h>
#include <spdlog/spdlog.h>

#include <thread>
#include <utility>

#include "clock/futex.h"
#include "daemon/thread_state.h"

namespace nao::daemon {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using Clock = std::chrono::steady_clock;

constexpr auto kLook = 50ms;  // between two looks at who has the turn
constexpr auto kServe = 2ms;  // between two looks at what clients send
constexpr auto kMoment = std::chrono::microseconds(50);
constexpr auto kLongTurn = 2s;    // of the wall
constexpr auto kLongStart = 10s;  // until a new program has begun
constexpr auto kBytes = 2s;       // until what was sent is here
constexpr double kBusy = 0.5;     // [s] of the processor's, in a long turn: it computes

bool lives(const clock::Slot& slot) {
  const auto state = slot.state.load();
  return state != clock::SlotState::Free && state != clock::SlotState::Ended;
}

}  // namespace

bool WorldTurns::anyoneLives() const {
  for (std::uint32_t i = 0; i < page_.slots_used.load(); ++i)
    if (lives(page_.slots[i])) return true;
  return false;
}

bool WorldTurns::await() {
  const std::uint32_t bell = page_.world_bell.load();
  if (page_.holder.load() != clock::kWorld) {
    io_.poll();  // much that a client sends needs somebody who takes it
    clock::waitWhile(page_.world_bell, bell, std::chrono::nanoseconds(kServe).count());
    if (page_.holder.load() != clock::kWorld && Clock::now() > next_look_) watchHolder();
    return false;
  }
  if (awaitLeavers()) {  // whoever waits for their end goes on, and no time passes
    give();
    return false;
  }
  if (Clock::now() > next_look_) buryDead();
  if (anyoneLives()) return true;
  io_.poll();
  std::this_thread::sleep_for(1ms);  // nobody has come yet, or all have gone: time stands
  return false;
}

bool WorldTurns::hearClients() {
  const auto until = Clock::now() + kBytes;
  while (io_.poll(), !gate_.hasAll() && !io_.stopped()) {
    if (Clock::now() > until) {
      spdlog::warn("lockstep: bytes that a client sent did not come: this run is not repeatable");
      page_.strayed.fetch_add(1);
      break;
    }
    std::this_thread::sleep_for(kMoment);
  }
  return gate_.open();
}

bool WorldTurns::tellClients() {
  std::uint64_t before = 0;
  do {  // what is done may post more
    before = gate_.given();
    io_.poll();
  } while (gate_.given() != before);
  return gate_.given() != std::exchange(given_, gate_.given());
}

void WorldTurns::passTo(Duration time) {
  if (time > now()) page_.now = time.count();
}

void WorldTurns::give() {
  page_.happened.fetch_add(1);
  page_.passes_since_world = 0;
  const std::uint32_t next = clock::nextHolder(page_);
  if (next == clock::kWorld) return;
  watch_.holder = clock::kWorld;
  page_.holder = next;
  clock::ring(page_.slots[next].bell);
}

void WorldTurns::forget(std::int32_t process) {
  for (std::uint32_t i = 0; i < page_.slots_used.load(); ++i)
    if (page_.slots[i].process.load() == process) page_.slots[i].state = clock::SlotState::Free;
  for (clock::Link& link : page_.links) {
    if (link.used.load() == clock::kLinkFree || link.process.load() != process) continue;
    std::uint32_t open = clock::kLinkOpen;
    if (!link.used.compare_exchange_strong(open, clock::kLinkClosed)) link.used = clock::kLinkFree;
  }
}

// To who waits for signals: one has come, or comes once it lets them in.
void WorldTurns::tellOfDeath() {
  for (std::uint32_t i = 0; i < page_.slots_used.load(); ++i)
    if (page_.slots[i].queue == clock::kSignals) page_.slots[i].signalled = 1;
}

bool WorldTurns::awaitLeavers() {
  bool any = false;
  for (std::uint32_t i = 0; i < page_.slots_used.load(); ++i) {
    clock::Slot& slot = page_.slots[i];
    if (slot.state.load() != clock::SlotState::Leaving) continue;
    const std::int32_t process = slot.process.load();
    for (const auto until = Clock::now() + kLongTurn; isAlive(process) && Clock::now() < until;)
      std::this_thread::sleep_for(kMoment);
    forget(process);
    any = true;
  }
  if (any) tellOfDeath();
  return any;
}

void WorldTurns::buryDead() {
  next_look_ = Clock::now() + kLook;
  for (std::uint32_t i = 0; i < page_.slots_used.load(); ++i) {
    const std::int32_t process = page_.slots[i].process.load();
    if (lives(page_.slots[i]) && process > 0 && !isAlive(process)) forget(process);
  }
}

void WorldTurns::watchHolder() {
  next_look_ = Clock::now() + kLook;
  const std::uint32_t holder = page_.holder.load();
  if (holder == clock::kWorld) return;
  const clock::Slot& slot = page_.slots[holder];
  const std::int32_t process = slot.process.load();
  if (process > 0 && !isAlive(process)) {
    forget(process);
    tellOfDeath();
    return revoke(holder, nullptr);
  }
  const std::uint64_t passes = page_.passes.load();
  if (watch_.holder != holder || watch_.passes != passes) {
    watch_ = {holder, passes, Clock::now(), processorTime(process, slot.thread.load())};
    return;
  }
  const auto held = Clock::now() - watch_.since;
  if (slot.thread.load() == 0) {
    if (held > kLongStart) revoke(holder, "has not begun");
    return;
  }
  if (held < kLongTurn) return;
  const bool busy = page_.began.load() != 0 &&  // before, it may take its time
                    processorTime(process, slot.thread.load()) - watch_.busy > kBusy;
  if (busy || isAsleep(process, slot.thread.load())) {
    revoke(holder, busy ? "computes, or spins, without looking at a clock"
                        : "waits for something that is not seen here");
  }
}

// The thread goes on beside the turns until it next waits.
void WorldTurns::revoke(std::uint32_t holder, const char* why) {
  clock::Slot& slot = page_.slots[holder];
  if (why) {
    slot.state = slot.thread.load() == 0 ? clock::SlotState::Free : clock::SlotState::Beside;
    page_.strayed.fetch_add(1);
    report(slot, why);
  }
  page_.holder.compare_exchange_strong(holder, clock::kWorld);
}

// Once for each thread: the first time tells all.
void WorldTurns::report(const clock::Slot& slot, const char* why) {
  if (!reported_.insert(slot.order).second) return;
  spdlog::warn(
      "lockstep: thread {} of process {} had the turn for {} s and {}: it goes on beside the "
      "others, and this run is not repeatable",
      slot.thread.load(), slot.process.load(),
      std::chrono::duration_cast<std::chrono::seconds>(Clock::now() - watch_.since).count(), why);
}

}  // namespace nao::daemon
