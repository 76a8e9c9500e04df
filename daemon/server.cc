#include "daemon/server.h"

#include <algorithm>

#include "core/check.h"
#include "daemon/tcp_stream.h"

namespace nao::daemon {
namespace {

using boost::asio::ip::tcp;

constexpr std::chrono::milliseconds kBreath{100};  // after a failed accept: out of descriptors

tcp::endpoint endpointOf(const Address& address) {
  boost::system::error_code error;
  const auto parsed = boost::asio::ip::make_address(address.host, error);
  if (error) throw InputError("--listen: expected an IP address, found '" + address.host + "'");
  return {parsed, address.port};
}

}  // namespace

Server::Server(boost::asio::io_context& io, const Address& address, MakeConnection make_connection)
    : make_connection_(std::move(make_connection)), acceptor_(io), breath_(io) {
  const tcp::endpoint endpoint = endpointOf(address);
  try {
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    acceptor_.bind(endpoint);
    acceptor_.listen();
  } catch (const boost::system::system_error& error) {
    throw InputError(address.option + ": can not listen on " + address.host + ":" +
                     std::to_string(address.port) + " (" + error.code().message() +
                     "), expected a free port");
  }
  accept();
}

Server::~Server() { close(); }

void Server::close() {
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  breath_.cancel();
  while (!sessions_.empty()) {
    const auto session = sessions_.front();
    sessions_.pop_front();
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
    if (hasPlace()) take(std::move(socket));
    accept();
  });
}

bool Server::hasPlace() {
  if (sessions_.size() < kMostConnections) return true;
  const auto silent = std::find_if(sessions_.begin(), sessions_.end(),
                                   [](const auto& session) { return !session->isOpen(); });
  if (silent == sessions_.end()) return false;
  const auto session = *silent;
  session->close();  // and leaves the list
  return true;
}

void Server::take(tcp::socket socket) {
  auto stream = std::make_unique<TcpStream>(std::move(socket), buffer_);
  const auto session =
      std::make_shared<Session>(acceptor_.get_executor(), std::move(stream), make_connection_,
                                [this](const auto& closed) { sessions_.remove(closed); });
  sessions_.push_back(session);
  session->start();
}

}  // namespace nao::daemon
