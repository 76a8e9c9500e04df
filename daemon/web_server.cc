#include "daemon/web_server.h"

#include <openssl/rand.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "core/check.h"
#include "daemon/web_client.h"

namespace nao::daemon {
namespace {

std::string hostName() {
  char name[256] = {};
  return ::gethostname(name, sizeof name - 1) == 0 ? name : "";
}

}  // namespace

WebServer::WebServer(boost::asio::io_context& io, const Address& address, rpc::ServiceHub& hub,
                     WebContent content)
    : hub_(hub), content_(std::move(content)), own_name_(hostName()), acceptor_(io), breath_(io) {
  listenOn(acceptor_, address);
  accept();
}

WebServer::~WebServer() { close(); }

void WebServer::close() {
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  breath_.cancel();
  for (const auto& client : std::exchange(clients_, {})) client->close();
}

void WebServer::accept() {
  acceptor_.async_accept(
      [this](const boost::system::error_code& error, boost::asio::ip::tcp::socket socket) {
        if (error == boost::asio::error::operation_aborted || !acceptor_.is_open()) return;
        if (error) {
          breath_.expires_after(kBreath);
          breath_.async_wait([this](const auto& stopped) {
            if (!stopped) accept();
          });
          return;
        }
        if (clients_.size() < kMostClients) serveWebClient(*this, std::move(socket));
        accept();
      });
}

std::string WebServer::startSession() {
  unsigned char bytes[16];
  NAO_CHECK(RAND_bytes(bytes, sizeof bytes) == 1);
  constexpr char kDigits[] = "0123456789abcdef";
  std::string name;
  for (const unsigned char byte : bytes) {
    name += kDigits[byte >> 4U];
    name += kDigits[byte & 15U];
  }
  sessions_.push_back(name);
  if (sessions_.size() > kMostSessions) sessions_.pop_front();
  return name;
}

bool WebServer::takeSession(const std::string& name) {
  const auto found = std::find(sessions_.begin(), sessions_.end(), name);
  if (found == sessions_.end()) return false;
  sessions_.erase(found);
  return true;
}

}  // namespace nao::daemon
