#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "core/sim_time.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/value.h"

namespace nao::rpc {

/// Calls `then` once, when this much simulated time has passed. I/O thread.
using CallLater = std::function<void(Duration, std::function<void()> then)>;

/// The calls that ALProxy's .post started and that have not ended yet, by their task id. One count
/// for all services of the process, so an id is valid on any of them.
class Tasks {
 public:
  static constexpr std::size_t kMost = 1024;

  /// Without `call_later` a wait() has no time-out.
  explicit Tasks(CallLater call_later = {}) : call_later_(std::move(call_later)) {}

  /// The id of `call` while it runs; it is forgotten when it ends. @throws CallError if too many.
  std::int32_t start(const Pending<Value>& call);

  bool isRunning(std::int32_t id) const { return running_->count(id) > 0; }
  void stop(std::int32_t id);

  /// Ends with true if the time-out came first, with false when the task ended or is unknown.
  /// A time-out of 0 waits for ever.
  Pending<bool> wait(std::int32_t id, std::int32_t timeout_ms);

 private:
  CallLater call_later_;
  std::int32_t next_id_ = 1;
  using Running = std::map<std::int32_t, Pending<Value>>;
  std::shared_ptr<Running> running_ = std::make_shared<Running>();
};

}  // namespace nao::rpc
