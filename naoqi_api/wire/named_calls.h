#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "naoqi_api/service_hub.h"

namespace nao::wire {

using rpc::ObjectRef;
using rpc::Value;

/// What one client of a wire that goes by names (msgpack-RPC, qi.js) has under way: its calls, the
/// objects it was given, the signals it listens to. Targets are services by name, or objects by
/// "#" and the number they were handed out with. Destroying it is the client's going.
class NamedCalls {
 public:
  static constexpr std::size_t kMostUnfinished = 1024;
  static constexpr std::size_t kMostObjects = 4096;
  static constexpr std::size_t kMostSubscriptions = 4096;

  using Target = rpc::Pending<std::shared_ptr<rpc::Service>>;
  using Listener = std::function<void(std::uint64_t link, const std::vector<Value>& arguments)>;

  /// @param endpoint the address the client dialled.
  NamedCalls(rpc::ServiceHub& hub, std::string endpoint);
  NamedCalls(const NamedCalls&) = delete;
  NamedCalls& operator=(const NamedCalls&) = delete;
  ~NamedCalls();

  Target find(const std::string& target);

  rpc::Pending<Value> call(const std::string& target, const std::string& method,
                           const std::vector<Value>& arguments);
  rpc::Pending<Value> property(const std::string& target, const std::string& name);
  rpc::Pending<Value> setProperty(const std::string& target, const std::string& name,
                                  const Value& value);

  /// Ends with the link, a number to end it with; `listener` is told of every emission.
  rpc::Pending<Value> subscribe(const std::string& target, const std::string& signal,
                                Listener listener);
  bool unsubscribe(std::uint64_t link);

  /// The number an object is known by from now on; -1 for no object. @throws rpc::CallError
  std::int64_t give(const ObjectRef& object);
  bool release(std::int64_t object);

  /// The names of what may be called here.
  std::vector<std::string> serviceNames() const;

 private:
  struct Subscription {
    rpc::Emitter emitter;
    std::uint64_t link = 0;  // of the emitter
  };

  rpc::Pending<Value> whenFound(
      const std::string& target,
      std::function<rpc::Pending<Value>(NamedCalls&, rpc::Service&)> then);
  rpc::Pending<Value> listen(rpc::Service& service, const std::string& signal,
                             const Listener& listener);
  void keep(const rpc::Pending<Value>& result);

  rpc::ServiceHub& hub_;
  std::shared_ptr<rpc::Session> session_;
  std::map<std::int64_t, std::shared_ptr<rpc::Service>> objects_;
  std::map<const rpc::Service*, std::int64_t> numbers_;  // of objects_
  std::map<std::uint64_t, Subscription> subscriptions_;
  std::map<std::uint64_t, rpc::Pending<Value>> unfinished_;
  std::int64_t next_object_ = 0;
  std::uint64_t next_link_ = 1;
  std::uint64_t next_call_ = 1;
  std::shared_ptr<NamedCalls*> alive_ = std::make_shared<NamedCalls*>(this);
};

}  // namespace nao::wire
