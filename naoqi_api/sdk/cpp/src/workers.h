#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace nao::client {

/// Runs jobs in the order they came, one at a time; but while a job waits for an answer
/// (Workers::Waiting), the next may run, so that a module's method can call whatever it likes.
/// Threads start as needed.
class Workers {
 public:
  Workers() = default;
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// From any thread. False once stopped.
  bool post(std::function<void()> job);

  /// Waits for the jobs under way, except the caller's own; those not begun are dropped.
  void stop();

  /// While one lives, on a thread of some Workers, the next job may run there.
  class Waiting {
   public:
    Waiting();
    ~Waiting();
    Waiting(const Waiting&) = delete;
    Waiting& operator=(const Waiting&) = delete;

   private:
    Workers* workers_;
  };

 private:
  static constexpr std::size_t kMostThreads = 64;

  void run();
  void startOneIfNeeded();  // the lock is held

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  std::vector<std::thread> threads_;
  std::size_t running_ = 0;  // jobs that do not wait
  std::size_t idle_ = 0;     // threads without a job
  bool stopped_ = false;
};

}  // namespace nao::client
