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

Listener::Listener(boost::asio::io_context& io, const Address& address, const Take& take) {
  NAO_CHECK(!address.hosts.empty());
  std::uint16_t port = address.port;
  for (const std::string& host : address.hosts) {
    doors_.push_back(std::make_shared<Door>(io, take));
    listenOn(doors_.back()->acceptor, host, port, address.option);
    port = this->port();
  }
  for (const auto& door : doors_) door->accept();
}

Listener::~Listener() { close(); }

void Listener::close() {
  for (const auto& door : doors_) door->close();
}

void Listener::Door::close() {
  boost::system::error_code ignored;
  acceptor.close(ignored);
  breath.cancel();
}

void Listener::Door::accept() {
  acceptor.async_accept(
      [self = shared_from_this()](const boost::system::error_code& error, tcp::socket socket) {
        if (!self->acceptor.is_open()) return;
        if (error) return self->acceptLater();
        self->take(std::move(socket));
        if (self->acceptor.is_open()) self->accept();
      });
}

void Listener::Door::acceptLater() {
  breath.expires_after(kBreath);
  breath.async_wait([self = shared_from_this()](const auto& stopped) {
    if (!stopped && self->acceptor.is_open()) self->accept();
  });
}

}  // namespace nao::daemon
