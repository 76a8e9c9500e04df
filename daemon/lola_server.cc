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

void LolaServer::finish() {
  door_.takeWaiting();
  if (session_) session_->hearRest();
  close();
}

void LolaServer::close() {
  door_.close();
  if (session_) session_->close();
  session_.reset();
  if (!news_.peer) return;
  news_.peer.reset();
  tellNews();
}

void LolaServer::take(LolaDoor::Socket socket) {
  if (session_ && session_->hasLeft()) session_->hearRest();
  if (session_) return warn("a second client came and was closed: the first one is still there");
  session_ = std::make_shared<LolaSession>(*this, std::move(socket));
  news_.peer = std::make_shared<LolaPeer>(session_->descriptor());
  ++news_.clients;
  news_.answers_before = news_.answers;
  answered_ = 0;
  log("a client came");
  session_->start();
  tellNews();
}

void LolaServer::left(const std::string& how) {
  session_.reset();
  news_.peer.reset();
  log(how);
  tellNews();
}

void LolaServer::tellNews() {
  meeting_->news.publish(news_);
  heard_();
}

// A second map for the same frame, or one before it was read, completes the first.
void LolaServer::answered() {
  const std::uint64_t newest = news_.peer->framesSent();
  if (newest == answered_ || !news_.peer->hasReadAll()) return;
  answered_ = newest;
  ++news_.answers;
  tellNews();
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
