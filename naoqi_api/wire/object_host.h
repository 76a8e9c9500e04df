#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "naoqi_api/service_hub.h"
#include "naoqi_api/wire/channel.h"
#include "naoqi_api/wire/client_calls.h"
#include "naoqi_api/wire/codec.h"

namespace nao::wire {

// An object travels as
//   metaobject | u32 service | u32 object | 20 bytes uid, if both ends know ObjectPtrUID
// and, if both ends cache metaobjects,
//   bool transmitted | [metaobject] | u32 cache id | u32 service | u32 object | ...

/// The objects that one connection can reach: the services of the hub, each as object 1 of its
/// number, and what was handed out by value on this connection, until the client drops it or goes.
class ObjectHost : public ObjectCodec {
 public:
  static constexpr std::uint32_t kMain = 1;
  static constexpr std::size_t kMost = 4096;  // handed out and not dropped

  ObjectHost(rpc::ServiceHub& hub, std::shared_ptr<Channel> channel,
             std::shared_ptr<ClientCalls> client_calls)
      : hub_(hub), channel_(std::move(channel)), client_calls_(std::move(client_calls)) {}

  /// Null if there is no such object here.
  std::shared_ptr<rpc::Service> find(std::uint32_t service, std::uint32_t object) const;

  /// The client needs this object no more.
  void drop(std::uint32_t service, std::uint32_t object);

  /// Objects that are encoded from now on count as handed out by this service.
  void setGiver(std::uint32_t service) { giver_ = service; }

  void encode(Bytes& out, const ObjectRef& object) override;
  ObjectRef decode(Decoder& decoder) override;

 private:
  static constexpr std::uint32_t kFirstHandedOut = 3;

  void encodeMetaObject(Bytes& out, const Value& metaobject);
  Value decodeMetaObject(Decoder& decoder);

  rpc::ServiceHub& hub_;
  std::shared_ptr<Channel> channel_;
  std::shared_ptr<ClientCalls> client_calls_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::shared_ptr<rpc::Service>> handed_out_;
  std::map<std::uint32_t, Value> client_metaobjects_;  // that the client sent, by its cache id
  std::uint32_t giver_ = 0;
  std::uint32_t next_object_ = kFirstHandedOut;
  std::uint32_t next_cache_id_ = 1;
};

}  // namespace nao::wire
