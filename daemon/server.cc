#include "daemon/server.h"

#include "core/check.h"

namespace nao::daemon {
namespace {

using boost::asio::ip::tcp;

constexpr std::chrono::milliseconds kBreath{100};  // after a failed accept: out of descriptors

tcp::endpoint endpointOf(const std::string& address, std::uint16_t port) {
  boost::system::error_code error;
  const auto parsed = boost::asio::ip::make_address(address, error);
  if (error) throw InputError("--listen: expected an IP address, found '" + address + "'");
  return {parsed, port};
}

}  // namespace

Server::Server(boost::asio::io_context& io, rpc::ServiceHub& hub, const std::string& address,
               std::uint16_t port)
    : hub_(hub), acceptor_(io), breath_(io) {
  const tcp::endpoint endpoint = endpointOf(address, port);
  try {
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
  } catch (const boost::system::system_error& error) {
    throw InputError("--port: can not listen on " + address + ":" + std::to_string(port) + " (" +
                     error.code().message() + "), expected a free port");
  }
  accept();
}

Server::~Server() { close(); }

void Server::close() {
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  breath_.cancel();
  while (!sessions_.empty()) {
    const auto session = *sessions_.begin();
    sessions_.erase(sessions_.begin());
    session->close();
  }
}

void Server::accept() {
  acceptor_.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
    if (error == boost::asio::error::operation_aborted || !acceptor_.is_open()) return;
    if (error) {
      breath_.expires_after(kBreath);
      breath_.async_wait([this](const auto& stopped) {
        if (!stopped) accept();
      });
      return;
    }
    if (sessions_.size() < kMostConnections) {
      const auto session =
          std::make_shared<Session>(std::move(socket), hub_, buffer_,
                                    [this](const auto& closed) { sessions_.erase(closed); });
      sessions_.insert(session);
      session->start();
    }
    accept();
  });
}

}  // namespace nao::daemon
