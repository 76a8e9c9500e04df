#include "daemon/tcp_stream.h"

#include <netinet/tcp.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/write.hpp>
#include <utility>

namespace nao::daemon {

void tuneSocket(boost::asio::ip::tcp::socket& socket) {
  using boost::asio::detail::socket_option::integer;
  boost::system::error_code ignored;
  socket.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  socket.set_option(boost::asio::socket_base::keep_alive(true), ignored);
  socket.set_option(integer<IPPROTO_TCP, TCP_KEEPIDLE>(30), ignored);  // [s]
  socket.set_option(integer<IPPROTO_TCP, TCP_KEEPINTVL>(3), ignored);  // [s]
  socket.set_option(integer<IPPROTO_TCP, TCP_KEEPCNT>(10), ignored);
  socket.set_option(integer<IPPROTO_TCP, TCP_USER_TIMEOUT>(30000), ignored);  // [ms]
}

std::string dialledAddress(const char* scheme, const boost::asio::ip::tcp::socket& socket) {
  boost::system::error_code ignored;
  const auto own = socket.local_endpoint(ignored);
  return std::string(scheme) + "://" + own.address().to_string() + ":" + std::to_string(own.port());
}

TcpStream::TcpStream(boost::asio::ip::tcp::socket socket, ReadBuffer& buffer)
    : socket_(std::move(socket)), buffer_(buffer) {
  Error ignored;
  socket_.non_blocking(true, ignored);
  tuneSocket(socket_);
}

void TcpStream::open(Done done) { done({}); }

void TcpStream::read(Got got) {
  socket_.async_wait(boost::asio::socket_base::wait_read,
                     [this, got = std::move(got)](const Error& waiting) {
                       if (waiting) return got(waiting, nullptr, 0);
                       Error error;
                       const auto count = socket_.read_some(boost::asio::buffer(buffer_), error);
                       if (error == boost::asio::error::would_block) error = {};
                       got(error, buffer_.data(), count);
                     });
}

// What the socket takes at once needs no turn of the loop.
void TcpStream::write(const rpc::Bytes& bytes, Done done) {
  Error error;
  const auto count = socket_.write_some(boost::asio::buffer(bytes), error);
  if (count == bytes.size()) return done({});
  boost::asio::async_write(
      socket_, boost::asio::buffer(bytes) + count,
      [done = std::move(done)](const Error& failed, std::size_t /*count*/) { done(failed); });
}

void TcpStream::close() {
  Error ignored;
  socket_.close(ignored);
}

}  // namespace nao::daemon
