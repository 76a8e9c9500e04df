#include "naoqi_api/tasks.h"

#include <chrono>

#include "naoqi_api/call_error.h"

namespace nao::rpc {

std::int32_t Tasks::start(const Pending<Value>& call) {
  if (running_->size() >= kMost) throw CallError("too many calls posted and not ended");
  const std::int32_t id = next_id_++;
  if (call.isDone()) return id;
  running_->emplace(id, call);
  call.whenDone([running = std::weak_ptr<Running>(running_), id](const Outcome<Value>& /*end*/) {
    if (const auto tasks = running.lock()) tasks->erase(id);
  });
  return id;
}

void Tasks::stop(std::int32_t id) {
  const auto found = running_->find(id);
  if (found == running_->end()) return;
  const Pending<Value> call = found->second;
  call.cancel();
}

Pending<bool> Tasks::wait(std::int32_t id, std::int32_t timeout_ms) {
  Pending<bool> result;
  const auto found = running_->find(id);
  if (found == running_->end()) {
    result.resolve(false);
    return result;
  }
  found->second.whenDone([result](const Outcome<Value>& /*outcome*/) { result.resolve(false); });
  if (timeout_ms > 0 && call_later_) {
    call_later_(std::chrono::milliseconds(timeout_ms), [result] { result.resolve(true); });
  }
  return result;
}

}  // namespace nao::rpc
