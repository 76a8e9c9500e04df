#include "daemon/server.h"

#include <iterator>
#include <vector>

#include "daemon/places.h"

namespace nao::daemon {

using boost::asio::ip::tcp;

Server::Server(boost::asio::io_context& io, const Address& address, MakeStream make_stream,
               MakeConnection make_connection, std::shared_ptr<ByteBudget> budget)
    : make_stream_(std::move(make_stream)),
      make_connection_(std::move(make_connection)),
      budget_(std::move(budget)),
      listener_(io, address, [this](tcp::socket socket) {
        if (hasPlace()) take(std::move(socket));
      }) {}

Server::~Server() { close(); }

void Server::close() {
  listener_.close();
  while (!sessions_.empty()) {
    const auto session = sessions_.front();
    sessions_.pop_front();
    session->close();
  }
}

bool Server::hasPlace() {
  if (sessions_.size() < kMostConnections) return true;
  std::vector<Guest> guests;
  for (const auto& session : sessions_) guests.push_back({session->isOpen(), session->lastHeard()});
  const auto who = whoGivesWay(guests, std::chrono::steady_clock::now());
  if (!who) return false;
  const auto session = *std::next(sessions_.begin(), static_cast<std::ptrdiff_t>(*who));
  session->close();  // and leaves the list
  return true;
}

void Server::take(tcp::socket socket) {
  auto stream = make_stream_(std::move(socket), buffer_);
  const auto session =
      std::make_shared<Session>(listener_.executor(), std::move(stream), make_connection_, budget_,
                                [this](const auto& closed) { sessions_.remove(closed); });
  sessions_.push_back(session);
  session->start();
}

}  // namespace nao::daemon
