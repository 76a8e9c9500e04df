#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <string>

#include "daemon/listening.h"
#include "daemon/session.h"

namespace nao::daemon {

/// Makes the byte stream of a socket; the buffer may be lent to it.
using MakeStream =
    std::function<std::unique_ptr<Stream>(boost::asio::ip::tcp::socket, Stream::ReadBuffer&)>;

/// Listens for the clients of one wire of one robot. I/O thread.
///
/// When all places are taken, a client that comes takes that of the one that has been silent since
/// it came longest; if all have opened their connections, it is accepted and closed.
class Server {
 public:
  static constexpr std::size_t kMostConnections = 1024;

  /// @throws InputError naming the address when it can not be listened on.
  Server(boost::asio::io_context& io, const Address& address, MakeStream make_stream,
         MakeConnection make_connection);
  ~Server();

  std::uint16_t port() const { return acceptor_.local_endpoint().port(); }
  std::size_t connectionCount() const { return sessions_.size(); }
  void close();

 private:
  void accept();

  void take(boost::asio::ip::tcp::socket socket);
  bool hasPlace();

  MakeStream make_stream_;
  MakeConnection make_connection_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer breath_;
  Stream::ReadBuffer buffer_{};
  std::list<std::shared_ptr<Session>> sessions_;  // the oldest first
};

}  // namespace nao::daemon
