#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/memory/memory_store.h"
#include "naoqi_api/remote_object.h"
#include "naoqi_api/session.h"

namespace nao::services {

/// Finds a module that a client hosts, by name; null if there is none.
using FindModule = std::function<std::shared_ptr<rpc::RemoteObject>(const std::string& name)>;

/// The modules to call when an event is raised: ALMemory.subscribeToEvent. A module has one
/// callback per event; it goes with the client that asked for it, or with the module. I/O thread.
class AlMemoryCallbacks {
 public:
  AlMemoryCallbacks(memory::MemoryStore& store, FindModule find_module);

  /// Who is to be called, and how: method(event, value, message), or with fewer arguments.
  struct Callback {
    std::string module;
    std::string method;
    std::string message;
  };

  /// Replaces the module's callback for this event if it has one. `session` may be null. @throws
  /// CallError if the module can not be called, or there are too many callbacks.
  void add(const std::string& event, const Callback& callback,
           const std::shared_ptr<rpc::Session>& session);

  bool remove(const std::string& event, const std::string& module);
  void removeModule(const std::string& module);
  std::vector<std::string> modulesOf(const std::string& event) const;

  static constexpr std::size_t kMost = 4096;

 private:
  using Key = std::pair<std::string, std::string>;  // event, module
  struct Subscription {
    std::uint64_t session = 0;
    std::shared_ptr<void> token;  // of the store
  };
  struct State {
    std::map<Key, Subscription> subscriptions;
    std::set<std::uint64_t> watched_sessions;
  };

  void watch(rpc::Session& session);

  memory::MemoryStore& store_;
  FindModule find_module_;
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace nao::services
