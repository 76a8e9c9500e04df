#pragma once

#include <atomic>
#include <cstdint>

/// What a world and the programs that live in its time share: one page of memory. Plain C++ without
/// a library, as it is read in the midst of programs that are not ours.
///
/// In lockstep one thread at a time has the turn, or the world has it. Who has it alone writes
/// here, unless a field says otherwise.
namespace nao::clock {

constexpr std::uint64_t kMagic = 0x314b434f4c434f4eULL;  // and the layout's version
constexpr char kPageVariable[] = "USARNAOQI_CLOCK";      // names the page's file

constexpr std::int64_t kMicrosecond = 1000;
constexpr std::int64_t kMillisecond = 1000 * kMicrosecond;
constexpr std::int64_t kSecond = 1000 * kMillisecond;
constexpr std::int64_t kNever = INT64_MAX;

/// The queue of those who wait for signals alone; no address is like it.
constexpr std::uint64_t kSignals = 1;

/// Where the clocks begin. [ns]
constexpr std::int64_t kMonotonicStart = 1000 * kSecond;

/// A call that is answered at once takes the client so long.
constexpr std::int64_t kCallCost = 500 * kMicrosecond;
/// Looks at clocks that cost nothing, one after another; each further one costs kLookCost.
constexpr std::uint32_t kFreeLooks = 1000;
constexpr std::int64_t kLookCost = 10 * kMicrosecond;

enum class Mode : std::uint32_t {
  Follow = 0,    // clocks show the world's time, programs run as they like
  Lockstep = 1,  // and take turns with the world
};

enum class SlotState : std::uint32_t {
  Free = 0,
  Running,  // has the turn
  Ready,    // may go on when its turn comes; also a thread that is yet to begin
  Trying,   // waits for something that only it can look at: a descriptor, a lock, a process
  Queued,   // waits until another thread says so (signalled), or for its deadline alone
  Beside,   // runs, or waits, outside of all turns
  Ended,    // a thread that somebody may still join
  Leaving,  // the last of a process: the world waits until the system knows of its end, too
};

/// One thread of a program.
struct Slot {
  std::atomic<SlotState> state;
  std::atomic<std::uint32_t> bell;  // a futex: rung when the turn is given to it
  std::atomic<std::int32_t> process;
  std::atomic<std::int32_t> thread;  // 0: has not begun
  std::uint64_t order;               // of creation
  std::int64_t deadline;             // [ns] of page time
  std::uint64_t looked;              // how much had happened when it last tried
  std::uint64_t handle;              // its pthread_t
  std::uint64_t queue;               // what it waits for, an address in its process
  std::uint64_t ticket;              // its place in that queue
  std::uint32_t signalled;
  std::uint32_t detached;
  std::int64_t alarm;  // [ns] when its process wants SIGALRM; kNever
  std::int64_t alarm_interval;
};

constexpr std::uint32_t kLinkFree = 0;
constexpr std::uint32_t kLinkOpen = 1;
constexpr std::uint32_t kLinkClosed = 2;         // by the program
constexpr std::uint32_t kLinkClosedByWorld = 3;  // free once the program has closed it, too

/// One connection of a program to the world. Counts are of bytes since it was opened.
struct Link {
  std::atomic<std::uint32_t> used;  // kLink...
  std::atomic<std::int32_t> process;
  std::uint16_t from_port;
  std::uint16_t to_port;
  std::atomic<std::uint64_t> sent;      // by the program
  std::atomic<std::uint64_t> received;  // by the world
  std::atomic<std::uint64_t> given;     // by the world
  std::atomic<std::uint64_t> taken;     // by the program
};

constexpr std::uint32_t kSlots = 512;
constexpr std::uint32_t kLinks = 512;
constexpr std::uint32_t kPorts = 64;
constexpr std::uint32_t kWorld = kSlots;  // the turn's holder, when nobody else is

struct ClockPage {
  std::uint64_t magic;
  Mode mode;
  std::int64_t epoch;                 // [ns] since 1970, at page time 0
  std::atomic<std::int64_t> now;      // [ns] page time: simulated, never goes back
  std::atomic<std::uint32_t> beat;    // a futex, in Follow: rung when `now` has changed
  std::atomic<double> speed;          // [simulated s per s] in Follow; infinite: as fast as it goes
  std::atomic<std::int64_t> stopped;  // [ns] CLOCK_MONOTONIC when the world ended, from when on
                                      // all clocks go on by themselves; 0: it has not

  std::uint16_t ports[kPorts];       // where the world listens; 0 ends the list
  std::atomic<std::uint32_t> ready;  // a futex: the world can be reached
  std::atomic<std::uint32_t> holder;
  std::atomic<std::uint32_t> world_bell;  // a futex
  std::atomic<std::int64_t> world_due;    // the world takes its turn when `now` is there
  std::atomic<std::uint64_t> happened;    // grows whenever something may have become possible
  std::atomic<std::uint64_t> passes;      // of the turn, for who watches over it
  std::atomic<std::uint32_t> began;       // somebody has waited for the first time
  std::atomic<std::uint32_t> strayed;  // threads that left the turns: the run is not reproducible
  std::atomic<std::uint32_t> slots_used;  // all beyond are free
  std::uint64_t last_order;
  std::uint64_t last_ticket;
  std::uint64_t round;  // the order of the thread that had the turn last
  std::uint32_t passes_since_world;
  std::atomic<std::uint32_t> registry_lock;  // for slots and links of who has no turn yet

  Slot slots[kSlots];
  Link links[kLinks];
};

/// Whether the slot's thread could go on, or has to be asked, now.
inline bool mayRun(const ClockPage& page, const Slot& slot) {
  const std::int64_t now = page.now.load();
  switch (slot.state.load()) {
    case SlotState::Ready:
      return true;
    case SlotState::Trying:
      return slot.looked != page.happened.load() || slot.deadline <= now || slot.alarm <= now;
    case SlotState::Queued:
      return slot.signalled != 0 || slot.deadline <= now || slot.alarm <= now;
    default:
      return false;
  }
}

/// Whose turn is next: the world's when it is due; else the next thread's that may run, in the
/// order of creation and after page.round; else the world's.
inline std::uint32_t nextHolder(const ClockPage& page) {
  if (page.now.load() >= page.world_due.load()) return kWorld;
  const std::uint64_t after = page.round;
  std::uint32_t later = kWorld;  // the first in order after `after`
  std::uint32_t first = kWorld;  // the first in order at all
  for (std::uint32_t i = 0; i < page.slots_used.load(); ++i) {
    const Slot& slot = page.slots[i];
    if (!mayRun(page, slot)) continue;
    if (first == kWorld || slot.order < page.slots[first].order) first = i;
    if (slot.order <= after) continue;
    if (later == kWorld || slot.order < page.slots[later].order) later = i;
  }
  return later != kWorld ? later : first;
}

/// When the first waiting thread wants to go on at the latest; kNever if none says.
inline std::int64_t firstDeadline(const ClockPage& page) {
  std::int64_t first = kNever;
  for (std::uint32_t i = 0; i < page.slots_used.load(); ++i) {
    const Slot& slot = page.slots[i];
    const SlotState state = slot.state.load();
    if (state != SlotState::Trying && state != SlotState::Queued) continue;
    if (slot.deadline < first) first = slot.deadline;
    if (slot.alarm < first) first = slot.alarm;
  }
  return first;
}

}  // namespace nao::clock
