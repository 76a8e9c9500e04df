#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <cstdint>
#include <string>

namespace nao::daemon {

/// Where to listen.
struct Address {
  std::string host;        // an IP address
  std::uint16_t port = 0;  // 0: any free one
  std::string option;      // that names the port, for error texts
};

/// @throws InputError naming the address when it can not be listened on.
void listenOn(boost::asio::ip::tcp::acceptor& acceptor, const Address& address);

/// What to wait after an accept that failed: out of descriptors.
constexpr std::chrono::milliseconds kBreath{100};

}  // namespace nao::daemon
