#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "naoqi_api/remote_object.h"
#include "naoqi_api/wire/client_calls.h"

namespace nao::wire {

/// A RemoteObject reached through the connection of the client that hosts it. The client is told
/// when nobody here needs it any more.
class ClientObject : public rpc::RemoteObject, public std::enable_shared_from_this<ClientObject> {
 public:
  /// @param metaobject what the client says it offers; see wire/metaobject.h.
  ClientObject(const Value& metaobject, std::uint32_t service, std::uint32_t object,
               std::shared_ptr<ClientCalls> calls);
  /// What it offers is asked for at the first call.
  ClientObject(std::uint32_t service, std::uint32_t object, std::shared_ptr<ClientCalls> calls);
  ~ClientObject() override;

  rpc::Pending<Value> call(std::string_view name, const std::vector<Value>& arguments) override;
  bool isReachable() const override { return calls_->isOpen(); }

 private:
  struct Method {
    std::string name;
    std::string parameters;
    std::string returns;
  };

  void learn(const Value& metaobject);
  rpc::Pending<Value> ask();
  rpc::Pending<Value> callKnown(std::string_view name, const std::vector<Value>& arguments);

  bool is_known_ = false;
  std::map<std::uint32_t, Method> methods_;
  std::uint32_t service_;
  std::uint32_t object_;
  std::shared_ptr<ClientCalls> calls_;
};

}  // namespace nao::wire
