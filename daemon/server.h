#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <cstdint>
#include <memory>
#include <set>
#include <string>

#include "daemon/session.h"
#include "naoqi_api/service_hub.h"

namespace nao::daemon {

/// Listens for the clients of one robot. I/O thread. The hub outlives it.
class Server {
 public:
  /// The most connections at once; further ones are accepted and closed.
  static constexpr std::size_t kMostConnections = 1024;

  /// @throws InputError naming the address when it can not be listened on.
  Server(boost::asio::io_context& io, rpc::ServiceHub& hub, const std::string& address,
         std::uint16_t port);
  ~Server();

  std::uint16_t port() const { return acceptor_.local_endpoint().port(); }
  std::size_t connectionCount() const { return sessions_.size(); }
  void close();

 private:
  void accept();

  rpc::ServiceHub& hub_;
  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer breath_;
  Session::ReadBuffer buffer_{};
  std::set<std::shared_ptr<Session>> sessions_;
};

}  // namespace nao::daemon
