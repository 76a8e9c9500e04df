#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <string>

#include "daemon/byte_budget.h"
#include "daemon/half_message.h"
#include "daemon/stream.h"
#include "naoqi_api/wire/connection.h"

namespace nao::daemon {

/// Makes the connection of a client that dialled `endpoint`.
using MakeConnection = std::function<std::unique_ptr<wire::Connection>(const std::string& endpoint,
                                                                       wire::Connection::Send)>;

/// One client's socket: carries bytes to and from its connection and keeps its limits. Messages
/// that arise in one turn of the loop leave together. Above kStopReading unsent bytes it takes no
/// more messages from that client, above kGiveUp (events and late answers pile up) it closes:
/// replies and events are never dropped one by one. It also closes when all clients together leave
/// too much here and this one is among those who do. I/O thread.
class Session : public std::enable_shared_from_this<Session> {
 public:
  static constexpr std::size_t kStopReading = 1U << 20U;
  static constexpr std::size_t kGiveUp = 8U << 20U;
  static constexpr std::chrono::seconds kHalfMessage{30};  // a message begun must end by then
  static constexpr std::chrono::seconds kOpening{30};      // and the opening be over

  using Closed = std::function<void(const std::shared_ptr<Session>&)>;

  Session(boost::asio::any_io_executor executor, std::unique_ptr<Stream> stream,
          MakeConnection make_connection, std::shared_ptr<ByteBudget> budget, Closed closed);

  void start();

  /// Closes the socket and ends what the client had open; `closed` is told once.
  void close();

  /// False while the client has not said enough to be one.
  bool isOpen() const { return connection_ && connection_->isOpen(); }

  /// When bytes came last, at first when it came itself.
  std::chrono::steady_clock::time_point lastHeard() const { return last_heard_; }

 private:
  using Error = Stream::Error;

  void begin();
  void read();
  void got(const Error& error, const std::uint8_t* bytes, std::size_t count);
  void send(rpc::Bytes message);
  void flushSoon();
  void flush();
  void written(const Error& error);
  void watchHalfMessage();
  void closeAfter(boost::asio::steady_timer& clock, std::chrono::seconds patience);
  void closeSoon();
  bool mustCloseNow() const;
  void account();

  boost::asio::any_io_executor executor_;
  std::unique_ptr<Stream> stream_;
  MakeConnection make_connection_;
  BudgetShare share_;  // of bytes left lying, as counted last
  Closed closed_;
  HalfMessage half_message_;
  boost::asio::steady_timer half_message_clock_;
  boost::asio::steady_timer opening_clock_;
  std::unique_ptr<wire::Connection> connection_;
  std::chrono::steady_clock::time_point last_heard_ = std::chrono::steady_clock::now();
  std::deque<rpc::Bytes> unsent_;  // the first one may be on its way
  std::size_t unsent_bytes_ = 0;
  bool reading_ = false;
  bool writing_ = false;
  bool flush_is_due_ = false;
  bool flushing_ = false;
  bool opening_watched_ = true;
  bool overflowed_ = false;
  bool is_closed_ = false;
};

}  // namespace nao::daemon
