#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace nao::daemon {

/// The socket in the file system to which programs for a V6's body come. A socket that somebody
/// left behind gives way, one that is answered does not; this one goes with its owner. I/O thread.
class LolaDoor {
 public:
  using Socket = boost::asio::local::stream_protocol::socket;
  using Take = std::function<void(Socket)>;

  /// @throws InputError naming the path if somebody else answers there, it is no socket, or no
  /// socket can be made.
  LolaDoor(boost::asio::io_context& io, const std::string& path, const Take& take);
  ~LolaDoor();

  const std::string& path() const;

  /// Lets in those who wait now.
  void takeWaiting();
  void close();

 private:
  struct Impl;
  std::shared_ptr<Impl> impl_;  // kept by what has been asked of the kernel
};

}  // namespace nao::daemon
