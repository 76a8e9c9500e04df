#include "naoqi_api/services/al_memory_callbacks.h"

#include <iterator>

#include "naoqi_api/call_error.h"

namespace nao::services {
namespace {

using rpc::Value;

// Calls with (event, value, message). A module's method may leave out the message, or take nothing
// at all: one that does not fit is not called, so that fewer arguments may be tried.
void callBack(const std::shared_ptr<rpc::RemoteObject>& module, const std::string& method,
              const std::vector<Value>& arguments) {
  const auto called = module->call(method, arguments);
  if (arguments.empty()) return;
  called.whenDone([module, method, arguments](const rpc::Outcome<Value>& outcome) {
    if (!outcome.error || !module->isReachable()) return;
    constexpr std::size_t kAll = 3;
    std::vector<Value> fewer;
    if (arguments.size() == kAll) fewer = {arguments[0], arguments[1]};
    callBack(module, method, fewer);
  });
}

}  // namespace

AlMemoryCallbacks::AlMemoryCallbacks(memory::MemoryStore& store, FindModule find_module)
    : store_(store), find_module_(std::move(find_module)) {}

void AlMemoryCallbacks::add(const std::string& event, const Callback& callback,
                            const std::shared_ptr<rpc::Session>& session) {
  const auto module = find_module_ ? find_module_(callback.module) : nullptr;
  if (!module) {
    throw rpc::CallError("can not call back module " + callback.module +
                         ": none of that name can be reached here; subscriber(event).signal works");
  }
  const Key key(event, callback.module);
  auto& subscriptions = state_->subscriptions;
  if (subscriptions.count(key) == 0 && subscriptions.size() >= kMost) {
    throw rpc::CallError("too many callbacks: there are " + std::to_string(kMost) + " already");
  }
  const std::weak_ptr<State> state = state_;
  auto token = store_.listen(event, [=](const std::string& raised, const Value& value) {
    if (module->isReachable()) {
      callBack(module, callback.method, {raised, value, callback.message});
    } else if (const auto left = state.lock()) {
      left->subscriptions.erase(key);
    }
  });
  subscriptions[key] = {session ? session->id() : 0, std::move(token)};
  if (session) watch(*session);
}

void AlMemoryCallbacks::watch(rpc::Session& session) {
  const std::uint64_t id = session.id();
  if (!state_->watched_sessions.insert(id).second) return;
  session.onEnd([state = std::weak_ptr<State>(state_), id] {
    const auto left = state.lock();
    if (!left) return;
    auto& subscriptions = left->subscriptions;
    for (auto it = subscriptions.begin(); it != subscriptions.end();) {
      it = it->second.session == id ? subscriptions.erase(it) : std::next(it);
    }
    left->watched_sessions.erase(id);
  });
}

bool AlMemoryCallbacks::remove(const std::string& event, const std::string& module) {
  return state_->subscriptions.erase({event, module}) > 0;
}

void AlMemoryCallbacks::removeModule(const std::string& module) {
  for (auto it = state_->subscriptions.begin(); it != state_->subscriptions.end();) {
    it = it->first.second == module ? state_->subscriptions.erase(it) : std::next(it);
  }
}

std::vector<std::string> AlMemoryCallbacks::modulesOf(const std::string& event) const {
  std::vector<std::string> modules;
  for (auto it = state_->subscriptions.lower_bound({event, ""});
       it != state_->subscriptions.end() && it->first.first == event; ++it) {
    modules.push_back(it->first.second);
  }
  return modules;
}

}  // namespace nao::services
