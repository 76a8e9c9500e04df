#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "naoqi_api/value.h"

namespace nao::wire {

/// One client on one of the wires, without its socket: bytes in, bytes out. I/O thread only.
/// Destroying it is the client's going: what it had open ends, results that come later are dropped.
class Connection {
 public:
  /// Takes whole messages, in order; it must not destroy the connection.
  using Send = std::function<void(rpc::Bytes message)>;

  Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  virtual ~Connection() = default;

  /// Bytes as they came, in pieces of any size.
  virtual void receive(const std::uint8_t* bytes, std::size_t count) = 0;

  /// Leaves further messages where they are, and answers to earlier ones unsent, until resume():
  /// what was sent has not gone out yet. May be called while a message is being answered.
  virtual void hold() = 0;
  virtual void resume() = 0;
  virtual bool isHeld() const = 0;

  /// Whether the client broke the protocol: close after what was sent.
  virtual bool wantsClose() const = 0;

  /// `broken` is told when an event can not be sent, outside of any receive(): close then.
  virtual void onBroken(std::function<void()> broken) = 0;

  /// Bytes that wait here; more than 0 while a message has begun and not ended: close when that
  /// lasts and no other message is taken meanwhile.
  virtual std::size_t bytesHeld() const = 0;
  virtual std::uint64_t messagesTaken() const = 0;

  /// Whether the opening is over: the client has said who it is, or did what needs no such word.
  virtual bool isOpen() const = 0;
};

}  // namespace nao::wire
