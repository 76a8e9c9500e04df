#pragma once

#include <boost/asio/io_context.hpp>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "daemon/byte_budget.h"
#include "daemon/listener.h"
#include "naoqi_api/service_hub.h"

namespace nao::daemon {

/// Someone who has come to the web port: asks for pages, or speaks qi.js. I/O thread.
class WebClient {
 public:
  virtual ~WebClient() = default;
  virtual void close() = 0;
};

class PollSession;

/// What web clients are served.
struct WebContent {
  std::string page;                  // at /
  std::string script;                // at /libs/qi/2/qi.js
  std::vector<std::string> origins;  // of pages from elsewhere that may use the robot
};

/// HTTP for one robot: its page, the qi.js client, and qi.js' own wire (socket.io 0.9 over
/// WebSocket or by polling). Asks for user and token (HTTP's Basic) where the hub has credentials.
/// I/O thread.
class WebServer {
 public:
  static constexpr std::size_t kMostClients = 256;    // further ones are accepted and closed
  static constexpr std::size_t kMostSessions = 1024;  // handed out and not taken up; the oldest go

  /// @throws InputError naming the address when it can not be listened on.
  WebServer(boost::asio::io_context& io, const Address& address, rpc::ServiceHub& hub,
            WebContent content,
            std::shared_ptr<ByteBudget> budget = std::make_shared<ByteBudget>());
  ~WebServer();

  std::uint16_t port() const { return listener_.port(); }
  void close();

  // For its clients:
  rpc::ServiceHub& hub() { return hub_; }
  const WebContent& content() const { return content_; }
  const std::string& ownName() const { return own_name_; }
  const std::shared_ptr<ByteBudget>& budget() const { return budget_; }
  /// A session's unguessable name, to be taken up once, by a WebSocket or by polling.
  std::string startSession();
  bool takeSession(const std::string& name);
  /// The polling session of that name, which may begin here; null if there is none to be had.
  std::shared_ptr<PollSession> findPollSession(const std::string& name,
                                               const std::string& endpoint);
  void add(const std::shared_ptr<WebClient>& client) { clients_.insert(client); }
  void remove(const std::shared_ptr<WebClient>& client) { clients_.erase(client); }

 private:
  rpc::ServiceHub& hub_;
  WebContent content_;
  std::string own_name_;
  std::shared_ptr<ByteBudget> budget_;
  std::set<std::shared_ptr<WebClient>> clients_;
  std::deque<std::string> sessions_;  // not taken up
  std::map<std::string, std::weak_ptr<PollSession>> polling_;
  Listener listener_;
};

}  // namespace nao::daemon
