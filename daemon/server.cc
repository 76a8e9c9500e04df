#include "daemon/server.h"

#include <algorithm>

namespace nao::daemon {

using boost::asio::ip::tcp;

Server::Server(boost::asio::io_context& io, const Address& address, MakeStream make_stream,
               MakeConnection make_connection)
    : make_stream_(std::move(make_stream)),
      make_connection_(std::move(make_connection)),
      acceptor_(io),
      breath_(io) {
  listenOn(acceptor_, address);
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
  auto stream = make_stream_(std::move(socket), buffer_);
  const auto session =
      std::make_shared<Session>(acceptor_.get_executor(), std::move(stream), make_connection_,
                                [this](const auto& closed) { sessions_.remove(closed); });
  sessions_.push_back(session);
  session->start();
}

}  // namespace nao::daemon
