#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "naoqi_api/personality.h"
#include "naoqi_api/wire/frame.h"

namespace nao::wire {

using rpc::Capabilities;

/// The sending half of one connection, and what its two ends agreed on. Shared by everything that
/// may still answer on it; once closed it drops what it is given.
class Channel {
 public:
  /// `send` takes whole frames, in order.
  using Send = std::function<void(Bytes frame)>;

  Channel(Send send, Capabilities own) : send_(std::move(send)), own_(std::move(own)) {}

  const Capabilities& own() const { return own_; }
  void setPeer(Capabilities peer) { peer_ = std::move(peer); }

  /// Whether both ends can do it.
  bool shares(const std::string& capability) const;

  /// Sends with a number of our own, which it returns: Event, Capability, Call, Post.
  std::uint32_t sendNew(Message message);

  /// The same with a payload that others send, too.
  void sendNew(Message header, const Bytes& payload);

  /// Answers: same number and address as `call`.
  void reply(const Message& call, Bytes payload, std::uint8_t flags = 0);
  void error(const Message& call, const std::string& text);
  void canceled(const Message& call);

  void close() {
    send_ = {};
    on_fail_ = {};
  }

  /// Something could not be sent as it should: the connection is to be closed.
  void fail() {
    failed_ = true;
    if (on_fail_) on_fail_();
  }
  void onFail(std::function<void()> told) { on_fail_ = std::move(told); }
  bool hasFailed() const { return failed_; }
  bool isOpen() const { return static_cast<bool>(send_); }

 private:
  void answer(const Message& call, MessageType type, Bytes payload, std::uint8_t flags);
  void send(const Message& message);

  Send send_;
  Capabilities own_;
  Capabilities peer_;
  std::uint32_t next_id_ = 1;
  bool failed_ = false;
  std::function<void()> on_fail_;
};

}  // namespace nao::wire
