#include "naoqi_api/wire/object_host.h"

#include "core/check.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/object_uid.h"
#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/client_object.h"
#include "naoqi_api/wire/metaobject.h"

namespace nao::wire {
namespace {

constexpr std::size_t kUidSize = 20;
constexpr std::size_t kMostMetaObjects = 1024;
constexpr char kCache[] = "MetaObjectCache";
constexpr char kUid[] = "ObjectPtrUID";

const Signature& metaObjectType() {
  static const Signature type = Signature::of(metaObjectSignature());
  return type;
}

}  // namespace

namespace {

// What another client's object offers; what it passed by value is known at once.
std::shared_ptr<rpc::Service> offered(rpc::RemoteObject& object) {
  const auto offer = object.offer().outcome();
  return offer && offer->value ? *offer->value : nullptr;
}

}  // namespace

std::shared_ptr<rpc::Service> ObjectHost::find(std::uint32_t service, std::uint32_t object) const {
  if (object == kMain) {
    const auto* entry = hub_.find(service);
    if (!entry) return nullptr;
    return entry->service ? entry->service : entry->offer;
  }
  const auto found = handed_out_.find({service, object});
  return found == handed_out_.end() ? nullptr : found->second;
}

void ObjectHost::drop(std::uint32_t service, std::uint32_t object) {
  const auto node = handed_out_.extract({service, object});  // destroyed when already out
}

void ObjectHost::encodeMetaObject(Bytes& out, const Value& metaobject) {
  if (channel_->shares(kCache)) appendNumber<std::uint8_t>(out, 1);
  wire::encode(out, metaobject, metaObjectType());
  if (channel_->shares(kCache)) appendNumber(out, next_cache_id_++);
}

void ObjectHost::encode(Bytes& out, const ObjectRef& object) {
  std::uint32_t id = 0;  // of no object
  const auto service = object.remote ? offered(*object.remote) : object.local;
  if (service) {
    if (handed_out_.size() >= kMost) throw CodecError("too many objects handed out");
    id = next_object_++;
    handed_out_[{giver_, id}] = service;
    hub_.traceSignals(service);
  }
  const rpc::Service nothing("", "");
  encodeMetaObject(out, metaObjectOf(service ? *service : nothing,
                                     hub_.options().personality.documents_members));
  appendNumber(out, giver_);
  appendNumber(out, id);
  if (!channel_->shares(kUid)) return;
  const std::string uid =
      rpc::objectUid(hub_.options().machine_id + std::to_string(giver_) + "/" + std::to_string(id));
  out.insert(out.end(), uid.begin(), uid.end());
}

Value ObjectHost::decodeMetaObject(Decoder& decoder) {
  if (!channel_->shares(kCache)) return decoder.read(metaObjectType());
  const bool transmitted = decoder.number<std::uint8_t>() != 0;
  Value metaobject;
  if (transmitted) metaobject = decoder.read(metaObjectType());
  const auto id = decoder.number<std::uint32_t>();
  if (transmitted && client_metaobjects_.size() < kMostMetaObjects) {
    client_metaobjects_[id] = metaobject;
  }
  if (transmitted) return metaobject;
  const auto known = client_metaobjects_.find(id);
  if (known == client_metaobjects_.end()) throw CodecError("no metaobject of that number");
  return known->second;
}

ObjectRef ObjectHost::decode(Decoder& decoder) {
  const Value metaobject = decodeMetaObject(decoder);
  const auto service = decoder.number<std::uint32_t>();
  const auto object = decoder.number<std::uint32_t>();
  if (channel_->shares(kUid)) decoder.raw(kUidSize);
  if (object == 0) return {};
  if (auto ours = find(service, object)) return {std::move(ours), nullptr};
  return {nullptr, ClientObject::make(metaobject, {service, object, 0}, client_calls_)};
}

}  // namespace nao::wire
