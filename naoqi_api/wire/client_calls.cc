#include "naoqi_api/wire/client_calls.h"

#include <utility>

#include "naoqi_api/convert.h"
#include "naoqi_api/wire/bytes.h"
#include "naoqi_api/wire/event_values.h"
#include "naoqi_api/wire/metaobject.h"

namespace nao::wire {
namespace {

Message callTo(const Address& address, MessageType type, Bytes arguments, std::uint8_t flags) {
  Message message;
  message.type = type;
  message.flags = flags;
  message.address = address;
  message.payload = std::move(arguments);
  return message;
}

std::string errorText(const Message& answer, ObjectCodec* objects) {
  const Value error = Decoder(answer.payload, objects).read("m");
  const std::string* text = error.findText();
  return text ? *text : "the client's error has no text";
}

}  // namespace

rpc::Pending<Value> ClientCalls::call(const Address& address, const Value& arguments,
                                      const Signature& parameters, const std::string& returns) {
  rpc::Pending<Value> result;
  if (!channel_->isOpen() || open_.size() >= kMost) {
    result.fail(channel_->isOpen() ? "too many calls to this client" : "the client has gone");
    return result;
  }
  try {
    Bytes bytes;
    encode(bytes, arguments, parameters, objects_);
    const std::uint8_t flags = parameters.is('m') ? kFlagDynamic : std::uint8_t{0};
    const auto id = channel_->sendNew(callTo(address, MessageType::Call, std::move(bytes), flags));
    result.onCancel([weak = weak_from_this(), id] {
      if (const auto self = weak.lock()) self->cancel(id);
    });
    open_[id] = {address, result, returns};
  } catch (const CodecError& error) {
    result.fail(error.what());
  }
  return result;
}

void ClientCalls::post(const Address& address, Bytes arguments) {
  channel_->sendNew(callTo(address, MessageType::Post, std::move(arguments), 0));
}

void ClientCalls::cancel(std::uint32_t id) {
  const auto found = open_.find(id);
  if (found == open_.end()) return;
  const Open open = std::move(found->second);
  open_.erase(found);
  Bytes number;
  appendNumber(number, id);
  const Address address{open.address.service, open.address.object, 0};
  channel_->sendNew(callTo(address, MessageType::Cancel, std::move(number), 0));
}

rpc::Pending<void> ClientCalls::listen(const Address& signal, const rpc::Emitter& emitter) {
  const Place place(signal.service, signal.object, signal.action);
  if (!channel_->isOpen() || heard_.count(place) > 0) return rpc::Pending<void>::done();
  const std::uint64_t link = (std::uint64_t{signal.action} << 32U) | next_link_++;
  heard_.emplace(place, Heard{link, emitter});
  const auto answered =
      call({signal.service, signal.object, base_action::kRegisterEvent},
           Value::tuple({signal.service, signal.action, link}), Signature::of("(IIL)"), "L");
  const rpc::Pending<void> listening;
  answered.whenDone([listening](const rpc::Outcome<Value>& outcome) {
    if (outcome.value) return listening.resolve();
    listening.fail(outcome.error.value_or("canceled"));
  });
  endInTime(listening);
  return listening;
}

void ClientCalls::endInTime(const rpc::Pending<void>& listening) const {
  if (listening.isDone() || !alarm_) return;
  const auto forget = alarm_(kMostListenWait, [listening] { listening.resolve(); });
  listening.whenDone([forget](const auto& /*outcome*/) { forget(); });
}

void ClientCalls::stopListening(const Address& signal) {
  const auto found = heard_.find({signal.service, signal.object, signal.action});
  if (found == heard_.end()) return;
  const std::uint64_t link = found->second.link;
  heard_.erase(found);
  call({signal.service, signal.object, base_action::kUnregisterEvent},
       Value::tuple({signal.service, signal.action, link}), Signature::of("(IIL)"), "v");
}

void ClientCalls::takeEvent(const Message& event) {
  const Address& from = event.address;
  const auto found = heard_.find({from.service, from.object, from.action});
  if (found == heard_.end()) return;
  const rpc::Emitter emitter = found->second.emitter;
  const auto type = Signature::of(emitter.signature());
  try {
    Decoder decoder(event.payload, objects_);
    const bool dynamic = (event.flags & kFlagDynamic) != 0;
    const auto arguments = argumentsOf(dynamic ? decoder.read("m") : decoder.read(type), type);
    if (arguments) emitter.emit(*arguments);
  } catch (const CodecError&) {
    return;
  }
}

// Callers rely on the type: a dynamic is bent to it.
Value ClientCalls::result(const Open& open, const Message& answer) {
  const auto returns = Signature::parse(open.returns);
  if (!returns) throw CodecError("the client declares no valid type: " + open.returns);
  Decoder decoder(answer.payload, objects_);
  if ((answer.flags & kFlagDynamic) == 0) return decoder.read(*returns);
  auto fitting = rpc::convert(decoder.read("m"), *returns, rpc::Bend::Declared);
  if (!fitting) throw CodecError("the client's result is not " + returns->words());
  return *std::move(fitting);
}

void ClientCalls::take(const Message& answer) {
  const auto found = open_.find(answer.id);
  if (found == open_.end()) return;
  const Open open = std::move(found->second);
  open_.erase(found);
  try {
    if (answer.type == MessageType::Canceled) return open.result.cancelNow();
    if (answer.type == MessageType::Error) return open.result.fail(errorText(answer, objects_));
    open.result.resolve(result(open, answer));
  } catch (const CodecError& error) {
    open.result.fail(error.what());
  }
}

void ClientCalls::failAll() {
  heard_.clear();
  const auto all = std::exchange(open_, {});
  for (const auto& [id, open] : all) open.result.fail("the client has gone");
}

}  // namespace nao::wire
