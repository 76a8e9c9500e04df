#include "daemon/listening.h"

#include "core/check.h"

namespace nao::daemon {

using boost::asio::ip::tcp;

void listenOn(tcp::acceptor& acceptor, const Address& address) {
  boost::system::error_code error;
  const auto host = boost::asio::ip::make_address(address.host, error);
  if (error) throw InputError("--listen: expected an IP address, found '" + address.host + "'");
  const tcp::endpoint endpoint(host, address.port);
  try {
    acceptor.open(endpoint.protocol());
    acceptor.set_option(tcp::acceptor::reuse_address(true));
    acceptor.bind(endpoint);
    acceptor.listen();
  } catch (const boost::system::system_error& failure) {
    throw InputError(address.option + ": can not listen on " + address.host + ":" +
                     std::to_string(address.port) + " (" + failure.code().message() +
                     "), expected a free port");
  }
}

}  // namespace nao::daemon
