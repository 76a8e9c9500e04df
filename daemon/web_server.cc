#include "daemon/web_server.h"

#include <unistd.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "daemon/poll_session.h"
#include "daemon/random_name.h"
#include "daemon/web_client.h"

namespace nao::daemon {
namespace {

std::string hostName() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "";
}

}  // namespace

WebServer::WebServer(boost::asio::io_context& io, const Address& address, rpc::ServiceHub& hub,
                     WebContent content, std::shared_ptr<ByteBudget> budget)
    : hub_(hub),
      content_(std::move(content)),
      own_name_(hostName()),
      budget_(std::move(budget)),
      listener_(io, address, [this](boost::asio::ip::tcp::socket socket) {
        if (clients_.size() < kMostClients) serveWebClient(*this, std::move(socket));
      }) {}

WebServer::~WebServer() { close(); }

void WebServer::close() {
  listener_.close();
  for (const auto& client : std::exchange(clients_, {})) client->close();
}

std::string WebServer::startSession() {
  sessions_.push_back(makeRandomName());
  if (sessions_.size() > kMostSessions) sessions_.pop_front();
  return sessions_.back();
}

bool WebServer::takeSession(const std::string& name) {
  const auto found = std::find(sessions_.begin(), sessions_.end(), name);
  if (found == sessions_.end()) return false;
  sessions_.erase(found);
  return true;
}

std::shared_ptr<PollSession> WebServer::findPollSession(const std::string& name,
                                                        const std::string& endpoint) {
  const auto found = polling_.find(name);
  if (found != polling_.end()) return found->second.lock();
  if (clients_.size() >= kMostClients || !takeSession(name)) return nullptr;
  for (auto it = polling_.begin(); it != polling_.end();) {
    it = it->second.expired() ? polling_.erase(it) : std::next(it);
  }
  auto session = std::make_shared<PollSession>(*this, listener_.executor(), endpoint);
  polling_[name] = session;
  clients_.insert(session);
  return session;
}

}  // namespace nao::daemon
