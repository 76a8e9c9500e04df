#pragma once

#include <csignal>

#include <atomic>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/latest.h"

namespace nao::app {

/// Stands by while something takes long: shows on stderr how far it is and what time is left, and
/// ends the program at Ctrl-C with one sentence. On a terminal it draws one line again and again,
/// elsewhere it writes a line now and then. Made before any other thread.
class StandBy {
 public:
  explicit StandBy(std::string farewell);
  StandBy(const StandBy&) = delete;
  StandBy& operator=(const StandBy&) = delete;
  ~StandBy();

  /// What the last words are.
  void setFarewell(std::string farewell) { farewell_.publish(std::move(farewell)); }
  /// Shows and says nothing from now on.
  void hush() { hushed_ = true; }

  /// What is being done, and which part of all is done, 0 to 1. Any thread.
  void tell(const std::string& what, double part);
  /// A line of its own. The thread that made this.
  void say(const std::string& line);

 private:
  struct State {
    std::string what;
    double part = 0;
  };

  void watch();
  void show();
  void drawBar(const State& state);
  void writeLine(const State& state);
  std::string timeLeft(double part);

  sigset_t before_{};
  const std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
  const bool terminal_;
  Latest<std::string> farewell_;
  Latest<State> state_;
  std::atomic<bool> over_{false}, hushed_{false};
  // Of the thread that watches:
  std::vector<std::pair<double, double>> course_;  // time [s] and part
  std::string written_what_;
  double written_part_ = 0;
  std::chrono::steady_clock::time_point written_at_;
  bool drawn_ = false;
  std::thread thread_;
};

/// "40 s", "3 min", "2 h 10 min".
std::string roughTime(double seconds);

}  // namespace nao::app
