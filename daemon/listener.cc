#include "daemon/listener.h"

#include <boost/asio/ip/v6_only.hpp>
#include <chrono>
#include <utility>

#include "core/check.h"

namespace nao::daemon {
namespace {

using boost::asio::ip::tcp;

constexpr std::chrono::milliseconds kBreath{100};  // after an accept that failed

void listenOn(tcp::acceptor& acceptor, const std::string& host, std::uint16_t port,
              const std::string& option) {
  boost::system::error_code error;
  const auto ip = boost::asio::ip::make_address(host, error);
  if (error) throw InputError("--listen: expected an IP address, found '" + host + "'");
  const tcp::endpoint endpoint(ip, port);
  try {
    acceptor.open(endpoint.protocol());
    acceptor.set_option(tcp::acceptor::reuse_address(true));
    if (ip.is_v6()) acceptor.set_option(boost::asio::ip::v6_only(true));  // 0.0.0.0 beside ::
    acceptor.bind(endpoint);
    acceptor.listen();
  } catch (const boost::system::system_error& failure) {
    throw InputError(option + ": can not listen on " + host + ":" + std::to_string(port) + " (" +
                     failure.code().message() + "), expected a free port");
  }
}

}  // namespace

Listener::Listener(boost::asio::io_context& io, const Address& address, Take take)
    : take_(std::move(take)) {
  NAO_CHECK(!address.hosts.empty());
  std::uint16_t port = address.port;
  for (const std::string& host : address.hosts) {
    Door& door = doors_.emplace_back(io);
    listenOn(door.acceptor, host, port, address.option);
    port = this->port();
  }
  for (Door& door : doors_) accept(door);
}

Listener::~Listener() { close(); }

void Listener::close() {
  boost::system::error_code ignored;
  for (Door& door : doors_) {
    door.acceptor.close(ignored);
    door.breath.cancel();
  }
}

void Listener::accept(Door& door) {
  door.acceptor.async_accept(
      [this, &door](const boost::system::error_code& error, tcp::socket socket) {
        if (error == boost::asio::error::operation_aborted) return;  // it may be gone
        if (!door.acceptor.is_open()) return;
        if (!error) {
          take_(std::move(socket));
          return accept(door);
        }
        door.breath.expires_after(kBreath);
        door.breath.async_wait([this, &door](const auto& stopped) {
          if (!stopped) accept(door);
        });
      });
}

}  // namespace nao::daemon
