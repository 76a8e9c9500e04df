#include "daemon/lola_sender.h"

#include <linux/sockios.h>
#include <spdlog/spdlog.h>
#include <sys/ioctl.h>
#include <sys/socket.h>

#include <cerrno>
#include <string>
#include <utility>

namespace nao::daemon {
namespace {

bool hasReadAll(int socket) {
  int unread = 0;
  return ::ioctl(socket, SIOCOUTQ, &unread) != 0 || unread == 0;
}

}  // namespace

LolaSender::LolaSender(wire::LolaSensors encoder, std::shared_ptr<LolaMeeting> meeting,
                       Lockstep lockstep)
    : encoder_(std::move(encoder)), meeting_(std::move(meeting)), lockstep_(lockstep) {}

std::uint64_t LolaSender::heard() const {
  const auto count = meeting_->heard.get();
  return count ? *count : 0;
}

void LolaSender::send(const SensorFrame& frame, const JointCommand& command) {
  const auto peer = meeting_->peer.get();
  if (heard() != heard_then_) gave_up_ = false;
  sent_to_ = 0;
  heard_then_ = heard();
  if (!peer || peer->descriptor() < 0 || !hasReadAll(peer->descriptor())) return;
  const std::string& bytes = encoder_.encode(frame, command);
  const auto sent =
      ::send(peer->descriptor(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
  if (sent == static_cast<ssize_t>(bytes.size())) sent_to_ = peer->number();
  if (sent < 0 && errno != EAGAIN) gone_ = peer->number();
}

bool LolaSender::holdsTime(SimTime now) {
  if (!lockstep_.patience || now.time_since_epoch() % kCycle != Duration::zero()) return false;
  const auto peer = meeting_->peer.get();
  came_ = came_ || peer;
  if (!came_) return true;
  if (heard() == heard_then_) {  // an answered frame is followed by the next, whoever is there
    const bool is_there = peer && peer->number() != gone_;
    if (!is_there && lockstep_.for_next) return true;
    if (is_there && peer->number() == sent_to_ && isPatient()) return true;
  }
  waits_since_.reset();
  return false;
}

bool LolaSender::isPatient() {
  if (gave_up_) return false;
  const auto wall = std::chrono::steady_clock::now();
  if (!waits_since_) waits_since_ = wall;
  if (wall - *waits_since_ < *lockstep_.patience) return true;
  spdlog::warn("LoLA: no answer for {} s: the world goes on without it",
               lockstep_.patience->count());
  gave_up_ = true;
  return false;
}

}  // namespace nao::daemon
