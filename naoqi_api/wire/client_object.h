#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "naoqi_api/remote_object.h"
#include "naoqi_api/service.h"
#include "naoqi_api/wire/client_calls.h"

namespace nao::wire {

/// A RemoteObject reached through the connection of the client that hosts it. The client is told
/// when nobody here needs it any more.
class ClientObject : public rpc::RemoteObject, public std::enable_shared_from_this<ClientObject> {
 public:
  /// @param metaobject what the client says it offers; see wire/metaobject.h.
  static std::shared_ptr<ClientObject> make(const Value& metaobject, const Address& address,
                                            std::shared_ptr<ClientCalls> calls);
  /// What it offers is asked for at the first call.
  ClientObject(const Address& address, std::shared_ptr<ClientCalls> calls);
  ~ClientObject() override;

  rpc::Pending<Value> call(std::string_view name, const std::vector<Value>& arguments) override;
  rpc::Pending<std::shared_ptr<rpc::Service>> offer() override;
  bool isReachable() const override { return calls_->isOpen(); }

  /// Calls one of its members; the arguments fit `parameters`.
  rpc::Pending<Value> callMember(std::uint32_t uid, const Value& arguments,
                                 const Signature& parameters, const std::string& returns) {
    return calls_->call(member(uid), arguments, parameters, returns);
  }
  /// Emits its signal's events from now on, or no longer. See ClientCalls::listen().
  rpc::Pending<void> listen(std::uint32_t uid, const rpc::Emitter& emitter) {
    return calls_->listen(member(uid), emitter);
  }
  void stopListening(std::uint32_t uid) { calls_->stopListening(member(uid)); }

 private:
  struct Method {
    std::uint32_t uid = 0;
    std::string name;
    Signature parameters;
    std::string returns;
  };

  Address member(std::uint32_t uid) const { return {address_.service, address_.object, uid}; }
  void learn(const Value& metaobject);
  rpc::Pending<Value> callKnown(std::string_view name, const std::vector<Value>& arguments);

  Address address_;  // without an action
  std::shared_ptr<ClientCalls> calls_;
  Value metaobject_;  // void: not known yet
  std::vector<Method> methods_;
  std::weak_ptr<rpc::Service> offered_;
  std::optional<rpc::Pending<std::shared_ptr<rpc::Service>>> asked_;  // for the metaobject
};

}  // namespace nao::wire
