#include "naoqi_api/wire/client_calls.h"

#include <utility>

#include "naoqi_api/convert.h"

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
    open_[id] = {result, returns};
  } catch (const CodecError& error) {
    result.fail(error.what());
  }
  return result;
}

void ClientCalls::post(const Address& address, Bytes arguments) {
  channel_->sendNew(callTo(address, MessageType::Post, std::move(arguments), 0));
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
  const auto all = std::exchange(open_, {});
  for (const auto& [id, open] : all) open.result.fail("the client has gone");
}

}  // namespace nao::wire
