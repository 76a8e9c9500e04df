#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace nao::daemon {

/// Where to listen: on the same port of every host.
struct Address {
  std::vector<std::string> hosts;  // IP addresses
  std::uint16_t port = 0;          // 0: any free one
  std::string option;              // that names the port, for error texts
};

/// Accepts clients until it is closed or gone; when no descriptor is left it tries again later. I/O
/// thread.
class Listener {
 public:
  using Take = std::function<void(boost::asio::ip::tcp::socket)>;

  /// @throws InputError naming the address when it can not be listened on.
  Listener(boost::asio::io_context& io, const Address& address, const Take& take);
  ~Listener();

  std::uint16_t port() const { return doors_.front()->acceptor.local_endpoint().port(); }
  boost::asio::any_io_executor executor() { return doors_.front()->acceptor.get_executor(); }
  void close();

 private:
  // What has been asked of the kernel may be answered when the listener is gone: it keeps the door.
  struct Door : std::enable_shared_from_this<Door> {
    Door(boost::asio::io_context& io, Take taker)
        : acceptor(io), breath(io), take(std::move(taker)) {}
    void accept();
    void acceptLater();
    void close();

    boost::asio::ip::tcp::acceptor acceptor;
    boost::asio::steady_timer breath;
    Take take;
  };

  std::vector<std::shared_ptr<Door>> doors_;
};

}  // namespace nao::daemon
