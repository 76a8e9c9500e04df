#pragma once

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>

#include "daemon/half_message.h"
#include "naoqi_api/wire/qi_connection.h"

namespace nao::daemon {

/// One client's socket: carries bytes to and from its QiConnection and keeps its limits. Above
/// kStopReading unsent bytes it takes no more messages from that client, above kGiveUp (events and
/// late answers pile up) it closes: replies and events are never dropped one by one. I/O thread.
class Session : public std::enable_shared_from_this<Session> {
 public:
  static constexpr std::size_t kStopReading = 1U << 20U;
  static constexpr std::size_t kGiveUp = 8U << 20U;
  static constexpr std::chrono::seconds kHalfMessage{30};  // a message begun must end by then

  using Closed = std::function<void(const std::shared_ptr<Session>&)>;
  using ReadBuffer = std::array<std::uint8_t, 65536>;

  /// `buffer` is lent for the moment of a read and may be shared by all sessions of the thread.
  Session(boost::asio::ip::tcp::socket socket, rpc::ServiceHub& hub, ReadBuffer& buffer,
          Closed closed);

  void start();
  /// Closes the socket and ends what the client had open; `closed` is told once.
  void close();

 private:
  using Error = boost::system::error_code;

  void read();
  void readable(const Error& error);
  void send(rpc::Bytes frame);
  void write();
  void written(const Error& error, std::size_t count);
  void watchHalfMessage();
  bool mustCloseNow() const;

  boost::asio::ip::tcp::socket socket_;
  HalfMessage half_message_;
  boost::asio::steady_timer half_message_clock_;
  Closed closed_;
  std::unique_ptr<wire::QiConnection> connection_;
  ReadBuffer& buffer_;
  std::deque<rpc::Bytes> unsent_;
  std::size_t unsent_bytes_ = 0;
  bool reading_ = false;
  bool writing_ = false;
  bool overflowed_ = false;
};

}  // namespace nao::daemon
