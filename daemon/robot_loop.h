#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "core/latest.h"
#include "core/mailbox.h"
#include "daemon/pace.h"
#include "daemon/world_turns.h"
#include "runtime/simulation.h"

namespace nao::daemon {

struct PauseWorld {};
struct ResumeWorld {};
/// While paused: this many physics steps, then paused again.
struct StepWorld {
  std::int64_t steps = 1;
};
struct SetSpeed {
  double speed = 1;  // simulated seconds per second; infinite: as fast as it goes
};

/// What the simulator's user may ask of the loop.
struct LoopRequest {
  std::uint64_t id = 0;
  std::variant<PauseWorld, ResumeWorld, StepWorld, SetSpeed, runtime::WorldRequest> action;
};

/// How a request ended; every one gets exactly one.
struct LoopOutcome {
  std::uint64_t id = 0;
  std::string error;  // empty: done
};

/// How the loop is doing, published once per cycle.
struct LoopState {
  SimTime time{};
  double speed = 1;
  bool paused = false;
  bool healthy = true;
  std::uint64_t hash = 0;              // of the simulation; only while paused or stopped
  std::vector<std::string> snapshots;  // kept by name
};

/// The simulation thread: advances the simulation at its pace and nothing else. Owns the
/// simulation from start() to stop(). After every cycle, and after every request while paused, it
/// calls `after_cycle`, on its own thread.
class RobotLoop {
 public:
  RobotLoop(runtime::Simulation& simulation, double speed, std::function<void()> after_cycle);
  ~RobotLoop();

  void start();
  void stop();  // waits for the thread

  /// From any thread: time goes on only until it has to wait for somebody, is paused or has
  /// diverged; then calls `ended`, on the simulation thread, and nothing follows. Once.
  void finish(std::function<void()> ended);

  /// From any thread. False when too many requests wait.
  [[nodiscard]] bool post(LoopRequest request);

  Mailbox<LoopOutcome>& outcomes() { return outcomes_; }
  const Latest<LoopState>& state() const { return state_; }
  /// Of the physics; never changes.
  Duration stepSize() const { return simulation_.stepSize(); }

  /// Before start(): while this is true a world at full speed, or one that is stepped, waits: no
  /// picture may be missing. Called on the simulation thread; must not block.
  void holdWhile(std::function<bool()> hold) { hold_ = std::move(hold); }
  /// Before start(): meets the simulation also at every multiple of `cycle`, at its time and not
  /// before, and catches up less than one of them when it is late.
  void keepBeat(Duration cycle);
  /// Before start(): while this is true the world waits, at any speed; one more of them. Called on
  /// the simulation thread; must not block.
  void lockTo(std::function<bool(SimTime now)> waits) { waits_.push_back(std::move(waits)); }
  /// Before start(): time stands at first.
  void beginPaused() { paused_ = true; }
  /// Before start(): called on the simulation thread whenever time is about to go on.
  void beforeBeat(std::function<void()> act) { before_beat_ = std::move(act); }
  /// Those who act at the end of a cycle, while time stands still, and ask for what is then done
  /// before the next.
  struct Guests {
    std::function<bool()> begin;       // false: nothing to wait for
    std::function<bool()> holds_time;  // until wake(), or until it says no
  };
  /// Before start(). Called on the simulation thread; must not block.
  void invite(Guests guests) { guests_ = std::move(guests); }
  /// Instead of start(): takes turns with clients, whose clocks show `turns`' time, on this thread,
  /// until `ended`.
  void alternateWith(WorldTurns& turns, const std::function<bool()>& ended);
  /// Before start(): clocks that follow the world's time.
  void showTimeOn(clock::ClockPage& page) { page_ = &page; }
  /// Before start(): told after every cycle, on the simulation thread, how long after it was due it
  /// was published.
  void onCycle(std::function<void(std::chrono::nanoseconds late)> told) { told_ = std::move(told); }
  /// From any thread: what the loop may be waiting for has changed.
  void wake();

 private:
  void run();
  void handleRequests();
  void handle(const LoopRequest& request);
  void apply(std::uint64_t id, const runtime::WorldRequest& request);
  void finish(std::uint64_t id, std::string error = {});
  void endSteps(const char* reason = "the steps were cut short");
  bool timeStands();
  bool awaitsPictures();
  void advance();
  SimTime nextBeat() const;
  void advanceTo(SimTime time);
  void hostGuests();
  void publish();
  void showTime();
  void takeTurn();
  bool settle();
  void goOnTo(Duration time);
  void beatOfTurns();
  void waitForPictures();
  Duration dueOfTurns() const;
  void waitUntil(Pace::Wall wall);

  runtime::Simulation& simulation_;
  std::function<void()> after_cycle_;
  std::function<bool()> hold_;
  std::vector<std::function<bool(SimTime)>> waits_;
  std::function<void()> before_beat_;
  std::vector<Duration> beats_;  // how often it looks at requests and clocks, simulated
  Guests guests_;
  WorldTurns* turns_ = nullptr;
  clock::ClockPage* page_ = nullptr;
  Duration ahead_{};  // of clients' clocks before simulated time: it stood, or was set back
  SimTime shown_{};   // simulated time then
  std::function<void(std::chrono::nanoseconds)> told_;
  Mailbox<LoopRequest> requests_{256};
  Mailbox<LoopOutcome> outcomes_{4096};
  std::vector<LoopOutcome> unsent_;
  Latest<LoopState> state_;
  Pace pace_;
  bool paused_ = false;
  std::int64_t steps_left_ = 0;
  std::uint64_t step_request_ = 0;

  std::mutex mutex_;
  std::condition_variable changed_;
  bool awake_ = false;
  std::atomic<bool> stopping_{false};
  Latest<std::function<void()>> at_end_;  // null: it is not to end yet
  std::thread thread_;
};

}  // namespace nao::daemon
