#include "daemon/poll_session.h"

#include <boost/asio/post.hpp>
#include <chrono>
#include <utility>

#include "daemon/session.h"
#include "naoqi_api/wire/socket_io.h"

namespace nao::daemon {
namespace {

constexpr std::chrono::seconds kLongestPoll{20};
constexpr std::chrono::seconds kAway{25};  // between two polls; as the handshake says
constexpr char kNothing[] = "8::";
constexpr char kEnded[] = "0::";

}  // namespace

PollSession::PollSession(WebServer& server, boost::asio::any_io_executor executor,
                         const std::string& endpoint)
    : server_(server), executor_(std::move(executor)), clock_(executor_), share_(server.budget()) {
  connection_ = std::make_unique<wire::QijsConnection>(
      server_.hub(), endpoint, [this](std::string text) { send(std::move(text)); },
      [this] { leaveSoon(); });
}

void PollSession::poll(Answer answer) {
  if (is_closed_) return answer(kEnded);
  if (waiting_) answerWith(kNothing);
  waiting_ = std::move(answer);
  flush();
  watch();
}

bool PollSession::take(std::string_view body) {
  const auto packets = wire::splitPackets(body);
  bool goes_on = packets.has_value();
  for (std::size_t i = 0; goes_on && i < packets->size(); ++i) {
    goes_on = !is_closed_ && connection_->receive((*packets)[i]);
  }
  if (!goes_on) leaveSoon();
  return goes_on;
}

void PollSession::send(std::string text) {
  if (is_closed_ || overflowed_) return;
  unsent_bytes_ += text.size();
  unsent_.push_back(std::move(text));
  const bool fits = share_.change(unsent_bytes_);
  overflowed_ = !fits || (unsent_bytes_ > Session::kGiveUp && unsent_.size() > 1);
  if (overflowed_) return leaveSoon();
  if (!waiting_) return;
  // What else arises in this turn of the loop goes with it.
  boost::asio::post(executor_, [self = shared_from_this()] { self->flush(); });
}

void PollSession::flush() {
  if (is_closed_ || !waiting_ || unsent_.empty()) return;
  unsent_bytes_ = 0;
  (void)share_.change(0);
  answerWith(wire::joinPackets(std::exchange(unsent_, {})));
  watch();
}

void PollSession::answerWith(std::string text) {
  const auto answer = std::exchange(waiting_, {});
  answer(std::move(text));
}

// The page is asked to ask again, or has gone.
void PollSession::watch() {
  clock_.expires_after(waiting_ ? kLongestPoll : kAway);
  clock_.async_wait([weak = weak_from_this()](const auto& stopped) {
    const auto self = weak.lock();
    if (!self || stopped || self->is_closed_) return;
    if (!self->waiting_) return self->leaveSoon();
    self->answerWith(kNothing);
    self->watch();
  });
}

void PollSession::leaveSoon() {  // the connection may be on the stack
  boost::asio::post(executor_, [self = shared_from_this()] {
    self->close();
    self->server_.remove(self);
  });
}

void PollSession::close() {
  if (std::exchange(is_closed_, true)) return;
  clock_.cancel();
  connection_.reset();
  (void)share_.change(0);
  if (waiting_) answerWith(kEnded);
}

}  // namespace nao::daemon
