#include "daemon/session.h"

#include <boost/asio/buffer.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/write.hpp>
#include <utility>

namespace nao::daemon {
namespace {

std::string addressOf(const boost::asio::ip::tcp::endpoint& endpoint) {
  return "tcp://" + endpoint.address().to_string() + ":" + std::to_string(endpoint.port());
}

}  // namespace

Session::Session(boost::asio::ip::tcp::socket socket, rpc::ServiceHub& hub, ReadBuffer& buffer,
                 Closed closed)
    : socket_(std::move(socket)),
      half_message_clock_(socket_.get_executor()),
      closed_(std::move(closed)),
      buffer_(buffer) {
  Error ignored;
  socket_.non_blocking(true, ignored);
  socket_.set_option(boost::asio::ip::tcp::no_delay(true), ignored);
  socket_.set_option(boost::asio::socket_base::keep_alive(true), ignored);
  const auto dialled = socket_.local_endpoint(ignored);
  connection_ = std::make_unique<wire::QiConnection>(
      hub, addressOf(dialled), [this](rpc::Bytes frame) { send(std::move(frame)); });
}

void Session::start() { read(); }

void Session::read() {
  if (reading_ || !socket_.is_open()) return;
  reading_ = true;
  socket_.async_wait(boost::asio::socket_base::wait_read,
                     [self = shared_from_this()](const Error& error) { self->readable(error); });
}

void Session::readable(const Error& waiting) {
  reading_ = false;
  if (waiting) return close();
  Error error;
  const std::size_t count = socket_.read_some(boost::asio::buffer(buffer_), error);
  if (error == boost::asio::error::would_block) return read();
  if (error) return close();
  if (!connection_) return;
  connection_->receive(buffer_.data(), count);
  if (mustCloseNow()) return close();
  if (connection_->wantsClose()) return;  // what was sent goes out first; see written()
  watchHalfMessage();
  if (!connection_->isHeld()) read();
}

void Session::send(rpc::Bytes frame) {
  if (overflowed_ || !socket_.is_open()) return;
  unsent_bytes_ += frame.size();
  unsent_.push_back(std::move(frame));
  if (unsent_bytes_ > kStopReading && connection_) connection_->hold();
  if (unsent_bytes_ > kGiveUp && unsent_.size() > 1) {  // one large answer alone may go
    overflowed_ = true;  // the connection is on the stack: close it from the loop
    boost::asio::post(socket_.get_executor(), [self = shared_from_this()] { self->close(); });
  } else if (!writing_) {
    write();
  }
}

void Session::write() {
  writing_ = true;
  boost::asio::async_write(socket_, boost::asio::buffer(unsent_.front()),
                           [self = shared_from_this()](const Error& error, std::size_t count) {
                             self->written(error, count);
                           });
}

void Session::written(const Error& error, std::size_t count) {
  writing_ = false;
  if (error || !connection_) return close();
  unsent_.pop_front();
  unsent_bytes_ -= count;
  if (!unsent_.empty()) write();
  if (connection_->isHeld() && unsent_bytes_ <= kStopReading) connection_->resume();
  if (mustCloseNow()) return close();
  if (!connection_->isHeld() && !connection_->wantsClose()) read();
}

bool Session::mustCloseNow() const {
  return overflowed_ || (connection_ && connection_->wantsClose() && unsent_.empty());
}

void Session::watchHalfMessage() {
  const auto clock = half_message_.look(connection_->holdsHalf(), connection_->isHeld(),
                                        connection_->messagesTaken());
  if (clock == HalfMessage::Clock::GoOn) return;
  half_message_clock_.cancel();
  if (clock == HalfMessage::Clock::Stop) return;
  half_message_clock_.expires_after(kHalfMessage);
  half_message_clock_.async_wait([weak = weak_from_this()](const Error& error) {
    const auto self = weak.lock();
    if (self && !error) self->close();
  });
}

void Session::close() {
  if (!connection_) return;
  const auto connection = std::move(connection_);
  Error ignored;
  socket_.close(ignored);
  half_message_clock_.cancel();
  closed_(shared_from_this());
}

}  // namespace nao::daemon
