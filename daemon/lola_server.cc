#include "daemon/lola_server.h"

#include <spdlog/spdlog.h>

#include <utility>

#include "daemon/lola_session.h"

namespace nao::daemon {

LolaServer::LolaServer(boost::asio::io_context& io, const std::string& path, Robot robot,
                       std::function<void()> heard)
    : robot_(std::move(robot)),
      heard_(std::move(heard)),
      door_(io, path, [this](LolaDoor::Socket socket) { take(std::move(socket)); }) {}

LolaServer::~LolaServer() { close(); }

void LolaServer::close() {
  door_.close();
  if (session_) session_->close();
  session_.reset();
  meeting_->peer.publish(std::shared_ptr<const LolaPeer>());
}

void LolaServer::take(LolaDoor::Socket socket) {
  if (session_ && session_->hasLeft()) {
    session_->close();
    left("the client left");
  }
  if (session_) return warn("a second client came and was closed: the first one is still there");
  session_ = std::make_shared<LolaSession>(*this, std::move(socket));
  meeting_->peer.publish(std::make_shared<const LolaPeer>(++clients_, session_->descriptor()));
  log("a client came");
  session_->start();
  heard_();
}

void LolaServer::left(const std::string& how) {
  session_.reset();
  meeting_->peer.publish(std::shared_ptr<const LolaPeer>());
  log(how);
  heard_();
}

void LolaServer::answered() {
  meeting_->heard.publish(++frames_);
  heard_();
}

void LolaServer::drive(BodyCommand command) {
  command.number = ++commands_;
  robot_.ports->body.publish(std::move(command));
}

void LolaServer::light(const std::vector<LedOrder>& orders) {
  for (const LedOrder& order : orders) lights_[order.leds] = order.brightness;
  postLights();
}

// All lights twice a cycle at most: other clients' orders have their place in the same mailbox.
void LolaServer::postLights() {
  while (!lights_.empty() && posted_lights_ < 2 * kMaxLeds &&
         robot_.ports->leds.post({lights_.begin()->first, lights_.begin()->second})) {
    lights_.erase(lights_.begin());
    ++posted_lights_;
  }
}

void LolaServer::deliver() {
  const auto state = robot_.ports->state.get();
  if (!state) return;
  if (state->time != lit_) {
    lit_ = state->time;
    posted_lights_ = 0;
    postLights();
  }
  if (session_) session_->checkSilence(state->time);
  if (drove_ && !state->driven)
    warn("no good frame for 500 ms, or the robot was reset: stiffness is off");
  drove_ = state->driven;
}

void LolaServer::log(const std::string& text) const {
  spdlog::info("LoLA of {}: {}", robot_.name, text);
}

void LolaServer::warn(const std::string& text) const {
  spdlog::warn("LoLA of {}: {}", robot_.name, text);
}

}  // namespace nao::daemon
