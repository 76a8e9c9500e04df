#include "daemon/lola_sender.h"

#include <spdlog/spdlog.h>

#include <utility>

namespace nao::daemon {

LolaSender::LolaSender(wire::LolaSensors encoder, std::shared_ptr<LolaMeeting> meeting,
                       std::optional<Seconds> patience)
    : encoder_(std::move(encoder)), meeting_(std::move(meeting)), patience_(patience) {}

void LolaSender::send(const SensorFrame& frame, const JointCommand& command) {
  sent_to_ = 0;
  const auto news = meeting_->news.get();
  if (!news) return;
  if (followed_ < news->answers_before) {  // this cycle is still that of the client before
    followed_ = news->answers_before;
    return;
  }
  if (news->answers != followed_) gave_up_ = false;
  followed_ = news->answers;
  greeted_ = news->clients;
  if (isThere(*news) && news->peer->hasReadAll()) sendTo(*news->peer, frame, command);
}

void LolaSender::sendTo(LolaPeer& peer, const SensorFrame& frame, const JointCommand& command) {
  const LolaPeer::Sent sent = peer.send(encoder_.encode(frame, command));
  if (sent == LolaPeer::Sent::Whole) sent_to_ = greeted_;
  if (sent == LolaPeer::Sent::Gone) gone_ = greeted_;
}

bool LolaSender::isThere(const LolaNews& news) const { return news.peer && news.clients != gone_; }

LolaSender::Wish LolaSender::wish(SimTime now) {
  if (!patience_ || now.time_since_epoch() % kCycle != Duration::zero()) return Wish::Go;
  const auto news = meeting_->news.get();
  if (!news) return Wish::Wait;
  if (news->answers == followed_ && news->clients == greeted_) {
    if (!isThere(*news)) return Wish::Rest;
    if (sent_to_ == greeted_ && isPatient()) return Wish::Wait;
  }
  waits_since_.reset();
  return Wish::Go;
}

bool LolaSender::isPatient() {
  if (gave_up_) return false;
  const auto wall = std::chrono::steady_clock::now();
  if (!waits_since_) waits_since_ = wall;
  if (wall - *waits_since_ < *patience_) return true;
  spdlog::warn("LoLA: no answer for {} s: the world goes on without it", patience_->count());
  gave_up_ = true;
  return false;
}

}  // namespace nao::daemon
