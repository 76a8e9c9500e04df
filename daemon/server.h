#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>

#include "daemon/listener.h"
#include "daemon/session.h"

namespace nao::daemon {

/// Makes the byte stream of a socket; the buffer may be lent to it.
using MakeStream =
    std::function<std::unique_ptr<Stream>(boost::asio::ip::tcp::socket, Stream::ReadBuffer&)>;

/// Listens for the clients of one wire of one robot. I/O thread.
///
/// When all places are taken, a client that comes takes that of one that has been silent too long
/// (daemon/places.h); if there is none, it is accepted and closed.
class Server {
 public:
  static constexpr std::size_t kMostConnections = 1024;

  /// @throws InputError naming the address when it can not be listened on.
  Server(boost::asio::io_context& io, const Address& address, MakeStream make_stream,
         MakeConnection make_connection,
         std::shared_ptr<ByteBudget> budget = std::make_shared<ByteBudget>());
  ~Server();

  std::uint16_t port() const { return listener_.port(); }
  void close();

 private:
  void take(boost::asio::ip::tcp::socket socket);
  bool hasPlace();

  MakeStream make_stream_;
  MakeConnection make_connection_;
  std::shared_ptr<ByteBudget> budget_;
  Stream::ReadBuffer buffer_{};
  std::list<std::shared_ptr<Session>> sessions_;  // the oldest first
  Listener listener_;
};

}  // namespace nao::daemon
