#include "daemon/web_client.h"

#include <boost/asio/dispatch.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/version.hpp>
#include <boost/beast/websocket.hpp>
#include <optional>
#include <utility>

#include "daemon/poll_session.h"
#include "daemon/tcp_stream.h"
#include "daemon/web_rules.h"
#include "daemon/web_socket.h"

namespace nao::daemon {
namespace {

namespace beast = boost::beast;
namespace http = beast::http;
using boost::asio::ip::tcp;

constexpr std::chrono::seconds kPatience{30};  // for one request, and until the next begins
constexpr std::uint32_t kMaxHeader = 8192;

/// Answers HTTP requests on one socket.
class HttpClient : public WebClient, public std::enable_shared_from_this<HttpClient> {
 public:
  HttpClient(WebServer& server, tcp::socket socket)
      : server_(server), endpoint_(dialledAddress("tcp", socket)), stream_(std::move(socket)) {
    tuneSocket(stream_.socket());
  }

  void start() {
    server_.add(shared_from_this());
    read();
  }

  void close() override {
    if (!is_closed_) stream_.close();
    is_closed_ = true;
  }

 private:
  using Request = http::request<http::string_body>;
  using Response = http::response<http::string_body>;

  void read() {
    parser_.emplace();
    parser_->header_limit(kMaxHeader);
    stream_.expires_after(kPatience);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = shared_from_this()](const auto& error, std::size_t /*count*/) {
                              if (error || self->is_closed_) return self->leave();
                              self->readBody();
                            });
  }

  // Only a page that polls has something to say, and only once it has a session.
  void readBody() {
    const WebRequest wanted = readTarget(targetOf(parser_->get()));
    const bool polls = wanted.kind == WebRequest::Kind::Poll &&
                       server_.findPollSession(wanted.session, endpoint_) != nullptr;
    parser_->body_limit(polls ? wire::QijsConnection::kMaxText : 0);
    http::async_read(stream_, buffer_, *parser_,
                     [self = shared_from_this()](const auto& error, std::size_t /*count*/) {
                       if (error || self->is_closed_) return self->leave();
                       self->take(self->parser_->get());
                     });
  }

  static std::string targetOf(const Request& request) { return std::string(request.target()); }

  void leave() {
    close();
    server_.remove(shared_from_this());
  }

  void take(const Request& request) {
    const WebRequest wanted = readTarget(targetOf(request));
    const WebAddress address{std::string(request[http::field::host]),
                             std::string(request[http::field::origin])};
    if (!isAllowed(address, server_.ownName(), server_.content().origins)) {
      return answer(request, http::status::forbidden, "Not from there: see --allow-origin.\n");
    }
    if (wanted.kind == WebRequest::Kind::Socket) return upgrade(request, wanted.session);
    if (wanted.kind == WebRequest::Kind::Poll) return poll(request, wanted.session);
    if (!mayPass(request)) return askWhoItIs(request);
    if (request.method() != http::verb::get) {
      return answer(request, http::status::method_not_allowed, "Expected GET.\n");
    }
    answer(request, wanted.kind);
  }

  bool mayPass(const Request& request) const {
    const auto& credentials = server_.hub().options().credentials;
    if (!credentials) return true;
    const auto header = request[http::field::authorization];
    return isAuthorized({header.data(), header.size()}, *credentials);
  }

  void askWhoItIs(const Request& request) {
    Response response(http::status::unauthorized, request.version());
    response.set(http::field::www_authenticate, "Basic realm=\"usarnaoqi\"");
    response.body() = "Expected a user and a token.\n";
    send(request, std::move(response), ++failures_ >= rpc::Credentials::kMostFailures);
  }

  void answer(const Request& request, WebRequest::Kind kind) {
    switch (kind) {
      case WebRequest::Kind::Page:
        return answer(request, http::status::ok, server_.content().page, "text/html");
      case WebRequest::Kind::Script:
        return answer(request, http::status::ok, server_.content().script, "text/javascript");
      case WebRequest::Kind::Handshake:  // session : heartbeats [s] : closed after [s] : transports
        return answer(request, http::status::ok,
                      server_.startSession() + ":15:25:websocket,xhr-polling");
      case WebRequest::Kind::Socket:
      case WebRequest::Kind::Poll:
      case WebRequest::Kind::Unknown:
        return answer(request, http::status::not_found, "There is nothing here.\n");
    }
  }

  void answer(const Request& request, http::status status, std::string text,
              const char* type = "text/plain") {
    Response response(status, request.version());
    response.set(http::field::content_type, std::string(type) + "; charset=utf-8");
    response.set(http::field::x_frame_options, "DENY");
    const auto origin = request[http::field::origin];
    if (status == http::status::ok && !origin.empty()) {
      response.set(http::field::access_control_allow_origin, origin);
      response.set(http::field::access_control_allow_credentials, "true");
      response.set(http::field::vary, "Origin");
    }
    response.body() = std::move(text);
    send(request, std::move(response), false);
  }

  void send(const Request& request, Response response, bool is_last) {
    response.keep_alive(request.keep_alive() && !is_last);
    response.prepare_payload();
    const auto kept = std::make_shared<Response>(std::move(response));
    http::async_write(stream_, *kept,
                      [self = shared_from_this(), kept](const auto& error, std::size_t /*count*/) {
                        const bool is_over = error || !kept->keep_alive() || self->is_closed_;
                        is_over ? self->leave() : self->read();
                      });
  }

  // The name of its session is what a page is known by.
  void poll(const Request& request, const std::string& name) {
    const auto session = server_.findPollSession(name, endpoint_);
    if (!session) {
      return answer(request, http::status::not_found, "Expected a session: shake hands first.\n");
    }
    if (request.method() == http::verb::post) {
      if (session->take(request.body())) return answer(request, http::status::ok, "1");
      return answer(request, http::status::bad_request, "Expected packets of socket.io 0.9.\n");
    }
    stream_.expires_never();
    session->poll([self = shared_from_this(), request](std::string text) {
      if (!self->is_closed_) self->answer(request, http::status::ok, std::move(text));
    });
  }

  void upgrade(const Request& request, const std::string& session) {
    if (!beast::websocket::is_upgrade(request)) {
      return answer(request, http::status::bad_request, "Expected a WebSocket.\n");
    }
    if (!server_.takeSession(session)) {
      return answer(request, http::status::not_found, "Expected a session: shake hands first.\n");
    }
    is_closed_ = true;  // the socket goes on in other hands
    stream_.expires_never();
    serveWebSocket(server_, stream_.release_socket(), parser_->release());
    server_.remove(shared_from_this());
  }

  WebServer& server_;
  std::string endpoint_;
  beast::tcp_stream stream_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::string_body>> parser_;
  int failures_ = 0;  // to say who it is
  bool is_closed_ = false;
};

}  // namespace

void serveWebClient(WebServer& server, tcp::socket socket) {
  std::make_shared<HttpClient>(server, std::move(socket))->start();
}

}  // namespace nao::daemon
