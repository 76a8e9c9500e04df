#include "daemon/session.h"

#include <boost/asio/post.hpp>
#include <utility>

namespace nao::daemon {
namespace {

// Small messages share a piece up to this size, so that many leave in one write.
constexpr std::size_t kPiece = 64U << 10U;

}  // namespace

Session::Session(boost::asio::any_io_executor executor, std::unique_ptr<Stream> stream,
                 MakeConnection make_connection, std::shared_ptr<ByteBudget> budget, Closed closed)
    : executor_(std::move(executor)),
      stream_(std::move(stream)),
      make_connection_(std::move(make_connection)),
      share_(std::move(budget)),
      closed_(std::move(closed)),
      half_message_clock_(executor_),
      opening_clock_(executor_) {}

void Session::start() {
  closeAfter(opening_clock_, kOpening);
  stream_->open([self = shared_from_this()](const Error& error) {
    if (error) return self->close();
    self->begin();
  });
}

void Session::begin() {
  if (is_closed_) return;
  connection_ = make_connection_(stream_->endpoint(),
                                 [this](rpc::Bytes message) { send(std::move(message)); });
  connection_->onBroken([this] { closeSoon(); });
  read();
}

void Session::read() {
  if (reading_ || is_closed_) return;
  reading_ = true;
  stream_->read([self = shared_from_this()](const Error& error, const std::uint8_t* bytes,
                                            std::size_t count) {
    self->reading_ = false;
    self->got(error, bytes, count);
  });
}

void Session::got(const Error& error, const std::uint8_t* bytes, std::size_t count) {
  if (error) return close();
  if (is_closed_) return;
  last_heard_ = std::chrono::steady_clock::now();
  connection_->receive(bytes, count);
  account();
  if (mustCloseNow()) return close();
  if (opening_watched_ && connection_->isOpen()) {
    opening_watched_ = false;
    opening_clock_.cancel();
  }
  if (connection_->wantsClose()) return;  // what was sent goes out first; see written()
  watchHalfMessage();
  if (!connection_->isHeld()) read();
}

void Session::send(rpc::Bytes message) {
  if (overflowed_ || is_closed_) return;
  unsent_bytes_ += message.size();
  const bool last_may_grow = unsent_.size() > (writing_ ? 1U : 0U);
  if (last_may_grow && unsent_.back().size() + message.size() <= kPiece) {
    unsent_.back().insert(unsent_.back().end(), message.begin(), message.end());
  } else {
    unsent_.push_back(std::move(message));
  }
  if (unsent_bytes_ > share_.bytes() + kPiece) account();
  if (unsent_bytes_ > kStopReading && connection_) connection_->hold();
  if (unsent_bytes_ > kGiveUp && unsent_.size() > 1) {  // one large answer alone may go
    overflowed_ = true;
    closeSoon();
  } else {
    flushSoon();
  }
}

void Session::account() {
  const std::size_t now = unsent_bytes_ + (connection_ ? connection_->bytesHeld() : 0);
  if (share_.change(now) || overflowed_) return;
  overflowed_ = true;
  closeSoon();
}

void Session::closeSoon() {  // the connection is on the stack
  boost::asio::post(executor_, [self = shared_from_this()] { self->close(); });
}

void Session::flushSoon() {
  if (writing_ || std::exchange(flush_is_due_, true)) return;
  boost::asio::post(executor_, [self = shared_from_this()] {
    self->flush_is_due_ = false;
    if (!self->writing_) self->flush();
  });
}

void Session::flush() {
  flushing_ = true;
  while (!writing_ && !is_closed_ && !unsent_.empty()) {
    writing_ = true;
    stream_->write(unsent_.front(),
                   [self = shared_from_this()](const Error& error) { self->written(error); });
  }
  flushing_ = false;
}

void Session::written(const Error& error) {
  writing_ = false;
  if (error || is_closed_) return close();
  unsent_bytes_ -= unsent_.front().size();
  unsent_.pop_front();
  account();
  if (!flushing_) flush();  // else the loop there goes on
  if (is_closed_) return;
  if (connection_->isHeld() && unsent_bytes_ <= kStopReading) connection_->resume();
  if (mustCloseNow()) return close();
  if (!connection_->isHeld() && !connection_->wantsClose()) read();
}

bool Session::mustCloseNow() const {
  return overflowed_ || (connection_ && connection_->wantsClose() && unsent_.empty());
}

void Session::watchHalfMessage() {
  const auto clock = half_message_.look(connection_->bytesHeld() > 0, connection_->isHeld(),
                                        connection_->messagesTaken());
  if (clock == HalfMessage::Clock::GoOn) return;
  half_message_clock_.cancel();
  if (clock == HalfMessage::Clock::Restart) closeAfter(half_message_clock_, kHalfMessage);
}

void Session::closeAfter(boost::asio::steady_timer& clock, std::chrono::seconds patience) {
  clock.expires_after(patience);
  clock.async_wait([weak = weak_from_this()](const Error& error) {
    const auto self = weak.lock();
    if (self && !error) self->close();
  });
}

void Session::close() {
  if (std::exchange(is_closed_, true)) return;
  (void)share_.change(0);
  const auto connection = std::move(connection_);
  stream_->close();
  half_message_clock_.cancel();
  opening_clock_.cancel();
  closed_(shared_from_this());
}

}  // namespace nao::daemon
