#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "naoqi_api/service_hub.h"
#include "naoqi_api/wire/channel.h"
#include "naoqi_api/wire/frame.h"

namespace nao::wire {

class Dispatcher;

/// One client on the qi wire, without its socket: bytes in, bytes out. I/O thread only. The hub
/// outlives it. Destroying it is the client's going: its subscriptions end, the services it had
/// registered go, and results that come later are dropped.
///
/// The first message decides how it goes on. An authentication (service 0, action 8) is always
/// granted. Anything else is an older client, which is answered at once, or is refused until it
/// authenticates, as the hub's personality says.
class QiConnection {
 public:
  /// @param endpoint the address the client dialled, tcp://host:port: services are listed there.
  /// @param send takes whole frames in order; it must not destroy the connection.
  QiConnection(rpc::ServiceHub& hub, std::string endpoint, Channel::Send send);
  QiConnection(const QiConnection&) = delete;
  QiConnection& operator=(const QiConnection&) = delete;
  ~QiConnection();

  /// Bytes as they came, in pieces of any size; answers go out before it returns.
  void receive(const std::uint8_t* bytes, std::size_t count);

  /// Leaves further messages where they are, and answers to earlier ones unsent, until resume():
  /// what was sent has not gone out yet.
  /// May be called while a message is being answered.
  void hold();
  void resume();
  bool isHeld() const { return held_; }

  /// True once the client broke the protocol: close after what was sent.
  bool wantsClose() const { return wants_close_ || channel_->hasFailed(); }

  /// True while a message has begun and not ended: close when that lasts (30 s) and no other
  /// message is taken meanwhile.
  bool holdsHalf() const { return reader_.holdsHalf(); }
  std::uint64_t messagesTaken() const { return messages_taken_; }

  /// Whether the opening is over.
  bool isOpen() const { return is_open_; }

 private:
  void takeAll();
  void take(const Message& message);
  bool isAuthentication(const Message& message) const;
  void authenticate(const Message& message);
  void takeCapabilities(const Message& message);
  void sendCapabilities();
  void open();

  rpc::ServiceHub& hub_;
  std::shared_ptr<Channel> channel_;
  std::shared_ptr<rpc::Session> session_;
  std::shared_ptr<Dispatcher> dispatcher_;
  FrameReader reader_;
  bool is_open_ = false;
  bool wants_close_ = false;
  bool held_ = false;
  std::uint64_t messages_taken_ = 0;
};

}  // namespace nao::wire
