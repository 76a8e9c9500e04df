#pragma once

#include <cstdint>
#include <ctime>

#include "clock/clock_page.h"

/// This program's side of the page.
namespace nao::clock {

/// Null: no world is there, everything is as without this library.
ClockPage* page();

/// This thread's slot when it takes turns; null in Follow, in threads nobody knows, and within a
/// signal's handler while the thread waits.
Slot* taker();

/// Page time. [ns]
std::int64_t pageNow();

/// A clock was read, or something was looked at in vain: costs nothing at first, see kFreeLooks.
void look();

enum class Woken { Ready, Late, Interrupted };

/// What a thread waits for.
class Waiting {
 public:
  /// Whether it is there; must not block. Called with the turn.
  virtual bool isThere() = 0;
  /// In Follow: waits for it, so many real nanoseconds at most, and says whether it is there.
  virtual bool block(std::int64_t real) = 0;

 protected:
  ~Waiting() = default;
};

/// Waits until it is there or page time `deadline` has come; `looks` at it at once at least.
Woken waitFor(Waiting& waiting, std::int64_t deadline);

/// The others first, as far as they may go on.
void yieldTurn();
/// The same, and the world if nothing has happened since the last time.
void letOthers();
/// Whether a thread of this process goes on outside of all turns.
bool anyBeside();

/// Lets time pass until `deadline`; never Ready.
Woken sleepUntil(std::int64_t deadline);

/// Enters a queue of this process by its address, in order; before whatever the queue is for is
/// given up.
void enterQueue(const void* queue);
/// Waits to be signalled there.
Woken waitInQueue(std::int64_t deadline);
/// Signals the first who waits there, or all. How many there were.
int signalQueue(const void* queue, bool all);

/// Threads: a slot for one that is to be made; the new one begins and ends; who joins.
Slot* makeSlot();
void dropSlot(Slot& slot);
void begin(Slot& slot);
void end();
Slot* findThread(std::uint64_t handle);
/// The process ends: nobody waits for its threads.
void leaveProcess();
Slot* leaveTurns();
void giveUp(Slot& slot);

/// How long a span of page time is for the wall in Follow; at full speed next to nothing.
std::int64_t realSpan(std::int64_t span);

/// Between the C library's times and page time.
bool isSimulated(clockid_t clock);
timespec toTimespec(std::int64_t ns);
std::int64_t fromTimespec(const timespec& time);
/// A clock's time at page time `now`, and the other way round. [ns]
std::int64_t onClock(clockid_t clock, std::int64_t now);
std::int64_t fromClock(clockid_t clock, const timespec& time);

/// Whether the address is code of the Python interpreter itself.
bool isInterpreter(const void* address);

}  // namespace nao::clock
