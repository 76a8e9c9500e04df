#include "daemon/lola_link.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>

#include "core/check.h"

namespace nao::daemon {

class LolaLink::Impl {
 public:
  explicit Impl(const std::string& path) : path_(path), socket_(io_) {
    boost::system::error_code error;
    socket_.connect(boost::asio::local::stream_protocol::endpoint(path), error);
    if (error) fail("expected a robot's LoLA socket: " + error.message());
  }

  std::string receive() {
    std::string frame(kSensorFrame, '\0');
    boost::system::error_code error;
    boost::asio::read(socket_, boost::asio::buffer(frame), error);
    if (error) fail("the robot closed the connection");
    return frame;
  }

  void send(const std::string& frame) {
    boost::system::error_code error;
    boost::asio::write(socket_, boost::asio::buffer(frame), error);
    if (error) fail("the robot closed the connection");
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(path_ + ": " + what); }

  std::string path_;
  boost::asio::io_context io_;
  boost::asio::local::stream_protocol::socket socket_;
};

LolaLink::LolaLink(const std::string& path) {
  constexpr std::size_t kLongest = 100;  // of a socket's path, less than any system's limit
  if (path.size() > kLongest) throw InputError(path + ": expected a socket's path of 100 letters");
  impl_ = std::make_unique<Impl>(path);
}
LolaLink::~LolaLink() = default;

std::string LolaLink::receive() { return impl_->receive(); }
void LolaLink::send(const std::string& frame) { impl_->send(frame); }

}  // namespace nao::daemon
