#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>

#include "daemon/web_server.h"

namespace nao::daemon {

/// Goes on with a socket whose HTTP request asks for the WebSocket of a qi.js session.
void serveWebSocket(WebServer& server, boost::asio::ip::tcp::socket socket,
                    boost::beast::http::request<boost::beast::http::string_body> request);

}  // namespace nao::daemon
