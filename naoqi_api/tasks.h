#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "core/sim_time.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/session.h"
#include "naoqi_api/value.h"

namespace nao::rpc {

/// Calls `then` once, when this much simulated time has passed. I/O thread.
using CallLater = std::function<void(Duration, std::function<void()> then)>;

/// The same; calling what it returns before then makes it not happen.
using Alarm = std::function<std::function<void()>(Duration, std::function<void()> then)>;

/// Numbers for posted calls, never used before. One for all robots of a process.
class TaskIds {
 public:
  std::int32_t take() { return next_++; }

 private:
  std::int32_t next_ = 1;
};

/// The calls that ALProxy's .post started and that have not ended yet, by their task id, which is
/// valid on any service of the robot. A call that only waits ends when its client goes, as do the
/// waits of a client for calls.
class Tasks {
 public:
  static constexpr std::size_t kMost = 16384;
  static constexpr std::size_t kMostPerClient = 1024;

  /// Without `alarm` a wait() has no time-out.
  explicit Tasks(Alarm alarm = {}, std::shared_ptr<TaskIds> ids = std::make_shared<TaskIds>());

  /// The id of `call` while it runs; it is forgotten when it ends. `client` may be null.
  /// @throws CallError if too many.
  std::int32_t start(const Pending<Value>& call, const std::shared_ptr<Session>& client = {});

  bool isRunning(std::int32_t id) const { return running_->count(id) > 0; }
  void stop(std::int32_t id);

  /// Ends with true if the time-out came first, with false when the task ended or is unknown.
  /// A time-out of 0 waits for ever.
  Pending<bool> wait(std::int32_t id, std::int32_t timeout_ms);

  /// Those that wait for a call.
  std::size_t waitCount(std::int32_t id) const;

 private:
  struct Task {
    Pending<Value> call;
    std::uint64_t client = 0;  // its session; 0: none
    std::map<std::uint64_t, Pending<bool>> waits;
  };
  using Running = std::map<std::int32_t, Task>;

  static void end(Running& running, std::int32_t id);
  std::size_t countOf(std::uint64_t client) const;
  void setAlarm(const Pending<bool>& wait, std::int32_t id, std::uint64_t number,
                std::int32_t timeout_ms) const;

  Alarm alarm_;
  std::shared_ptr<TaskIds> ids_;
  std::uint64_t next_wait_ = 1;
  std::shared_ptr<Running> running_ = std::make_shared<Running>();
};

}  // namespace nao::rpc
