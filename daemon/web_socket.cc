#include "daemon/web_socket.h"

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <string>
#include <utility>

#include "daemon/session.h"
#include "daemon/tcp_stream.h"
#include "naoqi_api/wire/qijs_connection.h"

namespace nao::daemon {
namespace {

namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::asio::ip::tcp;
using Request = beast::http::request<beast::http::string_body>;

constexpr std::chrono::seconds kHeartbeat{10};  // pages wait 15 s for one
constexpr int kMostSilentBeats = 3;

/// A qi.js page on its WebSocket, with the limits of a Session.
class SocketClient : public WebClient, public std::enable_shared_from_this<SocketClient> {
 public:
  SocketClient(WebServer& server, tcp::socket socket)
      : server_(server),
        endpoint_(dialledAddress("tcp", socket)),
        stream_(std::move(socket)),
        share_(server.budget()),
        heartbeat_(stream_.get_executor()) {
    stream_.read_message_max(wire::QijsConnection::kMaxText);
    stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    stream_.text(true);
  }

  void start(const Request& request) {
    server_.add(shared_from_this());
    stream_.async_accept(request, [self = shared_from_this()](const auto& error) {
      if (error || self->is_closed_) return self->leave();
      self->begin();
    });
  }

  void close() override {
    if (std::exchange(is_closed_, true)) return;
    heartbeat_.cancel();
    connection_.reset();
    beast::get_lowest_layer(stream_).close();
  }

 private:
  void begin() {
    connection_ = std::make_unique<wire::QijsConnection>(
        server_.hub(), endpoint_, [this](std::string text) { send(std::move(text)); },
        [this] { leaveSoon(); });
    beat();
    read();
  }

  void leave() {
    close();
    server_.remove(shared_from_this());
  }

  void leaveSoon() {  // the connection is on the stack
    boost::asio::post(stream_.get_executor(), [self = shared_from_this()] { self->leave(); });
  }

  void beat() {
    heartbeat_.expires_after(kHeartbeat);
    heartbeat_.async_wait([weak = weak_from_this()](const auto& error) {
      const auto self = weak.lock();
      if (!self || error) return;
      if (++self->silent_beats_ > kMostSilentBeats) return self->leave();
      self->send("2::");
      self->beat();
    });
  }

  void read() {
    reading_ = true;
    stream_.async_read(buffer_, [self = shared_from_this()](const auto& error, std::size_t count) {
      self->reading_ = false;
      if (error || self->is_closed_) return self->leave();
      self->silent_beats_ = 0;
      const auto bytes = self->buffer_.data();
      const std::string_view text(static_cast<const char*>(bytes.data()), count);
      const bool goes_on = self->stream_.got_text() && self->connection_->receive(text);
      self->buffer_.consume(count);
      if (!goes_on) return self->leave();
      if (self->unsent_bytes_ <= Session::kStopReading) self->read();
    });
  }

  void send(std::string text) {
    if (is_closed_ || overflowed_) return;
    unsent_bytes_ += text.size();
    unsent_.push_back(std::move(text));
    const bool fits = share_.change(unsent_bytes_);
    overflowed_ = !fits || (unsent_bytes_ > Session::kGiveUp && unsent_.size() > 1);
    if (overflowed_) return leaveSoon();
    if (!writing_) write();
  }

  void write() {
    writing_ = true;
    stream_.async_write(boost::asio::buffer(unsent_.front()),
                        [self = shared_from_this()](const auto& error, std::size_t /*count*/) {
                          self->written(error);
                        });
  }

  void written(const beast::error_code& error) {
    writing_ = false;
    if (error || is_closed_) return leave();
    unsent_bytes_ -= unsent_.front().size();
    unsent_.pop_front();
    (void)share_.change(unsent_bytes_);
    if (!unsent_.empty()) write();
    if (!reading_ && unsent_bytes_ <= Session::kStopReading) read();
  }

  WebServer& server_;
  std::string endpoint_;
  websocket::stream<beast::tcp_stream> stream_;
  beast::flat_buffer buffer_;
  BudgetShare share_;  // of unsent_bytes_
  boost::asio::steady_timer heartbeat_;
  std::unique_ptr<wire::QijsConnection> connection_;
  std::deque<std::string> unsent_;  // the first one is on its way
  std::size_t unsent_bytes_ = 0;
  int silent_beats_ = 0;
  bool reading_ = false;
  bool writing_ = false;
  bool overflowed_ = false;
  bool is_closed_ = false;
};

}  // namespace

void serveWebSocket(WebServer& server, tcp::socket socket, Request request) {
  const auto client = std::make_shared<SocketClient>(server, std::move(socket));
  // The request is needed until the answer to it is made, within start().
  client->start(request);
}

}  // namespace nao::daemon
