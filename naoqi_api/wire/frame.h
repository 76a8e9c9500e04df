#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "naoqi_api/value.h"

namespace nao::wire {

using rpc::Bytes;

// A qi frame, all integers little-endian:
//   u32 magic 0x42ADDE42 | u32 id | u32 payload size | u16 version 0 | u8 type | u8 flags |
//   u32 service | u32 object | u32 action | payload

constexpr std::size_t kHeaderSize = 28;
constexpr std::uint32_t kMagic = 0x42ADDE42;

/// The largest payload taken from a client, before and after it has authenticated.
constexpr std::size_t kMaxPayloadBefore = 64U << 10U;
constexpr std::size_t kMaxPayload = 16U << 20U;

enum class MessageType : std::uint8_t {
  Call = 1,
  Reply = 2,
  Error = 3,
  Post = 4,  // a call without an answer
  Event = 5,
  Capability = 6,
  Cancel = 7,
  Canceled = 8,
};

constexpr std::uint8_t kFlagDynamic = 1;     // the payload is one dynamic
constexpr std::uint8_t kFlagReturnType = 2;  // the signature wanted back follows the arguments

/// Where a message goes: an action (method, signal, property) of an object of a service.
struct Address {
  std::uint32_t service = 0;
  std::uint32_t object = 0;
  std::uint32_t action = 0;
};

struct Message {
  std::uint32_t id = 0;
  std::uint16_t version = 0;
  MessageType type = MessageType::Call;
  std::uint8_t flags = 0;
  Address address;
  Bytes payload;
};

/// The payload may be another than the message's own.
Bytes encodeFrame(const Message& message, const Bytes& payload);
inline Bytes encodeFrame(const Message& message) { return encodeFrame(message, message.payload); }

/// Cuts a stream of bytes into messages. Half a message in, nothing out.
class FrameReader {
 public:
  void setMaxPayload(std::size_t most) { max_payload_ = most; }

  /// Takes bytes as they arrive, in pieces of any size.
  void push(const std::uint8_t* bytes, std::size_t count);

  /// The next whole message. Nothing more comes once the stream is broken.
  std::optional<Message> next();

  /// True if what came is no qi stream (wrong magic) or a message is larger than allowed.
  bool isBroken() const { return broken_; }

  /// What waits for its rest, or to be cut.
  std::size_t bytesHeld() const { return buffer_.size() - start_; }

 private:
  bool startsWell();

  std::size_t max_payload_ = kMaxPayloadBefore;
  Bytes buffer_;
  std::size_t start_ = 0;  // of what has not been cut yet
  bool broken_ = false;
};

}  // namespace nao::wire
