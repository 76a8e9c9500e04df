#include "naoqi_api/wire/subscriptions.h"

#include <optional>

#include "core/check.h"
#include "naoqi_api/call_error.h"
#include "naoqi_api/convert.h"
#include "naoqi_api/wire/event_values.h"

namespace nao::wire {
namespace {

constexpr std::size_t kMaxWished = 1024;  // letters of a signature

}  // namespace

std::uint64_t Subscriptions::add(const Address& signal, std::uint64_t link,
                                 const rpc::Emitter& emitter, std::string wished) {
  if (wished.size() > kMaxWished) throw rpc::CallError("the signature is too long");
  if (all_.size() >= kMost) throw rpc::CallError("too many subscriptions on one connection");
  const std::uint64_t number = (std::uint64_t{signal.action} << 32U) | next_++;
  const auto added = all_.emplace(number, Subscription{signal, link, emitter, 0, std::move(wished),
                                                       Signature::of(emitter.signature())})
                         .first;
  const Subscription* known = &added->second;
  added->second.emitter_link =
      emitter.connect([this, known](const rpc::Emission& emission) { send(*known, emission); });
  return number;
}

bool Subscriptions::remove(const Address& signal, std::uint64_t link) {
  for (auto it = all_.begin(); it != all_.end(); ++it) {
    const Subscription& known = it->second;
    if (known.link == link && known.signal.service == signal.service &&
        known.signal.object == signal.object && known.signal.action == signal.action) {
      drop(it);
      return true;
    }
  }
  return false;
}

Subscriptions::All::iterator Subscriptions::drop(All::iterator subscription) {
  const Subscription dropped = std::move(subscription->second);
  const auto next = all_.erase(subscription);
  dropped.emitter.disconnect(dropped.emitter_link);
  return next;
}

std::function<void()> Subscriptions::dropper(std::uint64_t number) {
  return [weak = std::weak_ptr(alive_), number] {
    const auto self = weak.lock();
    if (!self) return;
    const auto found = (*self)->all_.find(number);
    if (found != (*self)->all_.end()) (*self)->drop(found);
  };
}

void Subscriptions::removeObject(std::uint32_t service, std::uint32_t object) {
  for (auto it = all_.begin(); it != all_.end();) {
    const Address& signal = it->second.signal;
    const bool is_its = signal.service == service && signal.object == object;
    it = is_its ? drop(it) : std::next(it);
  }
}

void Subscriptions::clear() {
  while (!all_.empty()) drop(all_.begin());
}

void Subscriptions::send(const Subscription& known, const rpc::Emission& emission) {
  Message event;
  event.type = MessageType::Event;
  event.address = known.signal;
  if (sendShared(event, known, emission)) return;
  objects_.setGiver(event.address.service);
  try {
    write(event, known, emission.arguments());
  } catch (const CodecError&) {
    return channel_->fail();  // events are never dropped silently
  }
  channel_->sendNew(std::move(event));
}

namespace {

/// Objects differ from connection to connection.
class NoObjects : public ObjectCodec {
 public:
  void encode(Bytes& /*out*/, const ObjectRef& /*object*/) override { fail(); }
  ObjectRef decode(Decoder& /*decoder*/) override { fail(); }

 private:
  [[noreturn]] static void fail() { throw CodecError("an object is not the same for all"); }
};

std::optional<Bytes> encodeForAll(const std::vector<Value>& arguments, const Signature& declared) {
  NoObjects objects;
  Bytes bytes;
  try {
    if (encodeEvent(bytes, arguments, declared, &objects)) return bytes;
  } catch (const CodecError&) {  // this connection's own
  }
  return std::nullopt;
}

}  // namespace

// False if this client's event is not as everybody's.
bool Subscriptions::sendShared(const Message& event, const Subscription& known,
                               const rpc::Emission& emission) {
  if (!known.wished.empty()) return false;
  const Bytes* bytes = emission.encoded(known.emitter.signature(), [&] {
    return encodeForAll(emission.arguments(), known.declared);
  });
  if (bytes) channel_->sendNew(event, *bytes);
  return bytes != nullptr;
}

void Subscriptions::write(Message& event, const Subscription& known,
                          const std::vector<Value>& arguments) {
  if (!known.wished.empty() && channel_->shares("MessageFlags")) {
    const auto type = Signature::parse(known.wished);
    const auto wished =
        type ? rpc::convert(Value::tuple(arguments), *type, rpc::Bend::Declared) : std::nullopt;
    if (wished) {
      event.flags = kFlagDynamic;
      return encodeDynamic(event.payload, *wished, &objects_);
    }
  }
  // a service emits what it declared
  NAO_CHECK(encodeEvent(event.payload, arguments, known.declared, &objects_));
}

}  // namespace nao::wire
