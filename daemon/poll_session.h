#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

#include "daemon/byte_budget.h"
#include "daemon/web_server.h"
#include "naoqi_api/wire/qijs_connection.h"

namespace nao::daemon {

/// A qi.js page without a WebSocket (socket.io's xhr-polling): it asks again and again for what
/// there is for it, and says what it has to say in requests of their own. I/O thread.
class PollSession : public WebClient, public std::enable_shared_from_this<PollSession> {
 public:
  using Answer = std::function<void(std::string text)>;

  PollSession(WebServer& server, boost::asio::any_io_executor executor,
              const std::string& endpoint);

  /// The page asks: `answer` is called once, now or when there is something, at the latest after
  /// kLongestPoll, with nothing to do. One that was still waiting is told that, too. Of a session
  /// that has ended: that it has.
  void poll(Answer answer);

  /// What the page says. False if that is none of its messages, or its good bye: it has gone.
  bool take(std::string_view body);

  void close() override;

 private:
  void send(std::string text);
  void flush();
  void answerWith(std::string text);
  void watch();
  void leaveSoon();

  WebServer& server_;
  boost::asio::any_io_executor executor_;
  boost::asio::steady_timer clock_;
  std::unique_ptr<wire::QijsConnection> connection_;
  Answer waiting_;
  std::deque<std::string> unsent_;
  std::size_t unsent_bytes_ = 0;
  BudgetShare share_;  // of unsent_bytes_
  bool overflowed_ = false;
  bool is_closed_ = false;
};

}  // namespace nao::daemon
