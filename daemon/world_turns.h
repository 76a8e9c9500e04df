#pragma once

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <set>

#include "clock/clock_page.h"
#include "core/sim_time.h"
#include "daemon/turn_gate.h"

namespace nao::daemon {

/// The world's side of lockstep: its turns among those of its clients' threads
/// (clock/clock_page.h). One thread is the simulation's and the clients' here: the daemon's io is
/// served in these calls and nowhere else.
class WorldTurns {
 public:
  WorldTurns(clock::ClockPage& page, boost::asio::io_context& io)
      : page_(page), io_(io), gate_(page) {}

  TurnGate& gate() { return gate_; }

  /// Whether the world has the turn now, and there is somebody to live in its time. Waits a short
  /// while for that; watches over who has the turn meanwhile: threads that end, and those that
  /// hold it for long.
  bool await();

  /// Hands over what clients have sent, all of it. Whether there was anything.
  bool hearClients();

  /// Does all that was posted to the daemon's io until now, and what follows from it. Whether
  /// clients were given anything since the last time.
  bool tellClients();

  /// Page time. [since the start]
  Duration now() const { return Duration(page_.now.load()); }
  void pass(Duration span) { page_.now += span.count(); }
  void passTo(Duration time);

  /// Whether nobody has anything to do, nor to look at again.
  bool everybodyWaits() const { return clock::nextHolder(page_) == clock::kWorld; }

  /// When the next waiting thread wants to go on; max: none says.
  Duration firstDeadline() const { return Duration(clock::firstDeadline(page_)); }

  /// The world takes its next turn then at the latest.
  void setDue(Duration time) { page_.world_due = time.count(); }

  /// Gives the turn to whoever is next, which may be the world again.
  void give();

 private:
  struct Watch {
    std::uint32_t holder = clock::kWorld;
    std::uint64_t passes = 0;
    std::chrono::steady_clock::time_point since{};
    double busy = 0;  // [s] processor time of the thread then
  };

  bool anyoneLives() const;
  void buryDead();
  bool awaitLeavers();
  void tellOfDeath();
  void watchHolder();
  void revoke(std::uint32_t holder, const char* why);
  void report(const clock::Slot& slot, const char* why);
  void forget(std::int32_t process);

  clock::ClockPage& page_;
  boost::asio::io_context& io_;
  TurnGate gate_;
  Watch watch_;
  std::chrono::steady_clock::time_point next_look_{};
  std::set<std::uint64_t> reported_;  // threads, by the order of their slots
  std::uint64_t given_ = 0;           // to clients, when last told
};

}  // namespace nao::daemon
