#include "naoqi_api/wire/channel.h"

#include "naoqi_api/wire/codec.h"

namespace nao::wire {
namespace {

bool has(const Capabilities& capabilities, const std::string& name) {
  const auto found = capabilities.find(name);
  return found != capabilities.end() && found->second;
}

}  // namespace

bool Channel::shares(const std::string& capability) const {
  return has(own_, capability) && has(peer_, capability);
}

std::uint32_t Channel::sendNew(Message message) {
  message.id = next_id_++;
  send(message);
  return message.id;
}

void Channel::sendNew(Message header, const Bytes& payload) {
  header.id = next_id_++;
  if (send_) send_(encodeFrame(header, payload));
}

void Channel::reply(const Message& call, Bytes payload, std::uint8_t flags) {
  answer(call, MessageType::Reply, std::move(payload), flags);
}

void Channel::error(const Message& call, const std::string& text) {
  Bytes payload;
  encodeDynamic(payload, text);
  answer(call, MessageType::Error, std::move(payload), 0);
}

void Channel::canceled(const Message& call) { answer(call, MessageType::Canceled, {}, 0); }

void Channel::answer(const Message& call, MessageType type, Bytes payload, std::uint8_t flags) {
  Message message;
  message.id = call.id;
  message.type = type;
  message.flags = flags;
  message.address = call.address;
  message.payload = std::move(payload);
  send(message);
}

void Channel::send(const Message& message) {
  if (send_) send_(encodeFrame(message));
}

}  // namespace nao::wire
