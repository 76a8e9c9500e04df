#pragma once

#include <boost/asio/ip/tcp.hpp>

#include "daemon/web_server.h"

namespace nao::daemon {

/// Serves one who came to the web port until they go: HTTP requests one after the other, or from
/// an upgrade on a WebSocket.
void serveWebClient(WebServer& server, boost::asio::ip::tcp::socket socket);

}  // namespace nao::daemon
