#include "naoqi_api/wire/frame.h"

#include <algorithm>

#include "naoqi_api/wire/bytes.h"

namespace nao::wire {
namespace {

Message readHeader(const std::uint8_t* header) {
  Message message;
  message.id = readNumber<std::uint32_t>(header + 4);
  message.version = readNumber<std::uint16_t>(header + 12);
  message.type = static_cast<MessageType>(header[14]);
  message.flags = header[15];
  message.address.service = readNumber<std::uint32_t>(header + 16);
  message.address.object = readNumber<std::uint32_t>(header + 20);
  message.address.action = readNumber<std::uint32_t>(header + 24);
  return message;
}

}  // namespace

Bytes encodeFrame(const Message& message, const Bytes& payload) {
  Bytes frame;
  frame.reserve(kHeaderSize + payload.size());
  appendNumber(frame, kMagic);
  appendNumber(frame, message.id);
  appendNumber(frame, static_cast<std::uint32_t>(payload.size()));
  appendNumber(frame, message.version);
  appendNumber(frame, static_cast<std::uint8_t>(message.type));
  appendNumber(frame, message.flags);
  appendNumber(frame, message.address.service);
  appendNumber(frame, message.address.object);
  appendNumber(frame, message.address.action);
  frame.insert(frame.end(), payload.begin(), payload.end());
  return frame;
}

void FrameReader::push(const std::uint8_t* bytes, std::size_t count) {
  if (broken_) return;
  if (start_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(start_));
    start_ = 0;
  }
  buffer_.insert(buffer_.end(), bytes, bytes + count);
}

bool FrameReader::startsWell() {
  constexpr std::uint8_t kStart[] = {0x42, 0xDE, 0xAD, 0x42};
  const std::size_t have = std::min(buffer_.size() - start_, sizeof(kStart));
  return std::equal(kStart, kStart + have, buffer_.begin() + static_cast<std::ptrdiff_t>(start_));
}

std::optional<Message> FrameReader::next() {
  if (broken_) return std::nullopt;
  if (!startsWell()) broken_ = true;
  const std::size_t have = buffer_.size() - start_;
  if (broken_ || have < kHeaderSize) return std::nullopt;
  const std::uint8_t* header = buffer_.data() + start_;
  const std::size_t size = readNumber<std::uint32_t>(header + 8);
  if (size > max_payload_) broken_ = true;
  if (broken_ || have < kHeaderSize + size) return std::nullopt;
  Message message = readHeader(header);
  message.payload.assign(header + kHeaderSize, header + kHeaderSize + size);
  start_ += kHeaderSize + size;
  if (start_ == buffer_.size()) {
    buffer_.clear();
    buffer_.shrink_to_fit();
    start_ = 0;
  }
  return message;
}

}  // namespace nao::wire
