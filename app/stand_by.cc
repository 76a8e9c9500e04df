#include "app/stand_by.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace nao::app {
namespace {

constexpr long kTick = 250'000'000;            // [ns] between two drawings
constexpr double kLinePart = 0.1;              // between two lines of a step,
constexpr std::chrono::seconds kLineTime(60);  // unless it takes longer

// Ctrl-C, the polite end, and our own waking up.
sigset_t expectedSignals() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int number : {SIGINT, SIGTERM, SIGUSR1}) ::sigaddset(&signals, number);
  return signals;
}

// 100 % is what nothing is left of.
double percent(double part) { return std::floor(100 * part); }

}  // namespace

std::string roughTime(double seconds) {
  const long whole = std::lround(seconds);
  if (whole < 90) return std::to_string(whole) + " s";
  const long minutes = std::lround(seconds / 60);
  if (minutes < 90) return std::to_string(minutes) + " min";
  return std::to_string(minutes / 60) + " h " + std::to_string(minutes % 60) + " min";
}

StandBy::StandBy(std::string farewell) : terminal_(::isatty(STDERR_FILENO) == 1) {
  setFarewell(std::move(farewell));
  const sigset_t signals = expectedSignals();
  ::pthread_sigmask(SIG_BLOCK, &signals, &before_);
  thread_ = std::thread([this] { watch(); });
}

StandBy::~StandBy() {
  over_ = true;
  ::pthread_kill(thread_.native_handle(), SIGUSR1);
  thread_.join();
  ::pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

void StandBy::tell(const std::string& what, double part) { state_.publish(State{what, part}); }

void StandBy::say(const std::string& line) {
  if (!hushed_) std::fprintf(stderr, "%s\n", line.c_str());
}

void StandBy::watch() {
  const sigset_t signals = expectedSignals();
  const timespec tick{0, kTick};
  while (!over_) {
    const int number = ::sigtimedwait(&signals, nullptr, &tick);
    if (number == SIGINT || number == SIGTERM) {
      if (!hushed_) {
        std::fprintf(stderr, "%s%s\n", drawn_ ? "\n" : "", farewell_.get()->c_str());
      }
      ::_exit(128 + number);  // as a shell says it; what is kept is kept already
    }
    if (!hushed_) show();
  }
  if (drawn_) std::fprintf(stderr, "\n");
}

void StandBy::show() {
  const auto state = state_.get();
  if (!state) return;
  if (terminal_) {
    drawBar(*state);
  } else {
    writeLine(*state);
  }
}

// From the later half of the time so far: what was kept from before goes by fast.
std::string StandBy::timeLeft(double part) {
  const std::chrono::duration<double> since = std::chrono::steady_clock::now() - begun_;
  const double now = since.count();
  course_.emplace_back(now, part);
  std::size_t from = 0;
  while (from + 1 < course_.size() && course_[from].first < now / 2) ++from;
  const double done = part - course_[from].second, took = now - course_[from].first;
  if (now < 3 || done <= 0) return "";
  return ", about " + roughTime(took * (1 - part) / done) + " left";
}

void StandBy::drawBar(const State& state) {
  constexpr int kWidth = 30;
  const int full = static_cast<int>(kWidth * state.part);
  const std::string bar = std::string(full, '#') + std::string(kWidth - full, '.');
  std::fprintf(stderr, "\r[%s] %3.0f %%%s: %s\x1b[K", bar.c_str(), percent(state.part),
               timeLeft(state.part).c_str(), state.what.c_str());
  drawn_ = true;
}

void StandBy::writeLine(const State& state) {
  const std::string left = timeLeft(state.part);
  const auto now = std::chrono::steady_clock::now();
  if (state.what == written_what_ && state.part < written_part_ + kLinePart &&
      now < written_at_ + kLineTime) {
    return;
  }
  std::fprintf(stderr, "%3.0f %%%s: %s\n", percent(state.part), left.c_str(), state.what.c_str());
  written_what_ = state.what;
  written_part_ = state.part;
  written_at_ = now;
}

}  // namespace nao::app
