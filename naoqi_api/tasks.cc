#include "naoqi_api/tasks.h"

#include <algorithm>
#include <chrono>

#include "naoqi_api/call_error.h"

namespace nao::rpc {

Tasks::Tasks(Alarm alarm, std::shared_ptr<TaskIds> ids)
    : alarm_(std::move(alarm)), ids_(std::move(ids)) {}

std::size_t Tasks::countOf(std::uint64_t client) const {
  return static_cast<std::size_t>(
      std::count_if(running_->begin(), running_->end(),
                    [client](const auto& entry) { return entry.second.client == client; }));
}

std::int32_t Tasks::start(const Pending<Value>& call, const std::shared_ptr<Session>& client) {
  const std::uint64_t owner = client ? client->id() : 0;
  const bool is_full = running_->size() >= kMost || (client && countOf(owner) >= kMostPerClient);
  if (is_full) throw CallError("too many calls posted and not ended");
  const std::int32_t id = ids_->take();
  if (call.isDone()) return id;
  running_->emplace(id, Task{call, owner, {}});
  std::uint64_t link = 0;
  if (client) link = client->onEnd([call] { call.abandon(); });
  call.whenDone([weak = std::weak_ptr<Running>(running_), client = std::weak_ptr<Session>(client),
                 id, link](const Outcome<Value>& /*end*/) {
    if (const auto session = client.lock()) session->forgetEnd(link);
    if (const auto running = weak.lock()) end(*running, id);
  });
  return id;
}

void Tasks::end(Running& running, std::int32_t id) {
  const auto ended = running.extract(id);
  if (ended.empty()) return;
  const auto waits = std::exchange(ended.mapped().waits, {});
  for (const auto& [number, wait] : waits) wait.resolve(false);
}

void Tasks::stop(std::int32_t id) {
  const auto found = running_->find(id);
  if (found == running_->end()) return;
  const Pending<Value> call = found->second.call;
  call.cancel();
}

Pending<bool> Tasks::wait(std::int32_t id, std::int32_t timeout_ms) {
  const auto found = running_->find(id);
  if (found == running_->end()) return Pending<bool>::done(false);
  const std::uint64_t number = next_wait_++;
  const Pending<bool> result;
  found->second.waits.emplace(number, result);
  setAlarm(result, id, number, timeout_ms);
  return result;
}

// The wait is forgotten when its time has come, and when its client goes.
void Tasks::setAlarm(const Pending<bool>& wait, std::int32_t id, std::uint64_t number,
                     std::int32_t timeout_ms) const {
  const auto forget = [weak = std::weak_ptr<Running>(running_), id, number] {
    const auto running = weak.lock();
    if (!running) return;
    const auto task = running->find(id);
    if (task != running->end()) task->second.waits.erase(number);
  };
  if (timeout_ms <= 0 || !alarm_) return wait.onlyWaits(forget);
  const auto cancel_alarm = alarm_(std::chrono::milliseconds(timeout_ms), [wait, forget] {
    forget();
    wait.resolve(true);
  });
  wait.onlyWaits([forget, cancel_alarm] {
    forget();
    cancel_alarm();
  });
  wait.whenDone([cancel_alarm](const auto& /*outcome*/) { cancel_alarm(); });
}

std::size_t Tasks::waitCount(std::int32_t id) const {
  const auto found = running_->find(id);
  return found == running_->end() ? 0 : found->second.waits.size();
}

}  // namespace nao::rpc
