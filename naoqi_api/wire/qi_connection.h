#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "naoqi_api/service_hub.h"
#include "naoqi_api/wire/channel.h"
#include "naoqi_api/wire/connection.h"
#include "naoqi_api/wire/frame.h"

namespace nao::wire {

class Dispatcher;

/// One client on the qi wire. The hub outlives it. When it goes its subscriptions end and the
/// services it had registered go.
///
/// The first message decides how it goes on. An authentication (service 0, action 8) is granted,
/// if the hub has credentials to whoever names some of them; a third failure closes. Anything else
/// is an older client, which is answered at once, or is refused until it authenticates, as the
/// hub's personality says; always refused if there are credentials.
class QiConnection : public Connection {
 public:
  /// @param endpoint the address the client dialled, tcp://host:port: services are listed there.
  /// @param send takes whole frames in order; it must not destroy the connection.
  QiConnection(rpc::ServiceHub& hub, std::string endpoint, Channel::Send send);
  ~QiConnection() override;

  /// Answers go out before it returns.
  void receive(const std::uint8_t* bytes, std::size_t count) override;

  void hold() override;
  void resume() override;
  bool isHeld() const override { return held_; }
  bool wantsClose() const override { return wants_close_ || channel_->hasFailed(); }
  void onBroken(std::function<void()> broken) override { channel_->onFail(std::move(broken)); }
  std::size_t bytesHeld() const override { return reader_.bytesHeld(); }
  std::uint64_t messagesTaken() const override { return messages_taken_; }
  bool isOpen() const override { return is_open_; }

 private:
  void takeAll();
  void take(const Message& message);
  bool isAuthentication(const Message& message) const;
  bool needsAuthentication() const;
  void authenticate(const Message& message);
  void takeCapabilities(const Message& message);
  void sendCapabilities();
  void open();
  void refuse(const Message& message);

  rpc::ServiceHub& hub_;
  std::shared_ptr<Channel> channel_;
  std::shared_ptr<rpc::Session> session_;
  std::shared_ptr<Dispatcher> dispatcher_;
  FrameReader reader_;
  bool is_open_ = false;
  int failures_ = 0;  // to authenticate
  bool wants_close_ = false;
  bool held_ = false;
  std::uint64_t messages_taken_ = 0;
};

}  // namespace nao::wire
