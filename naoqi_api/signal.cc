#include "naoqi_api/signal.h"

#include <algorithm>
#include <utility>

namespace nao::rpc {

Emitter::Emitter(std::string signature) : state_(std::make_shared<State>()) {
  state_->signature = std::move(signature);
}

void Emitter::pass(const Emission& emission) const {
  const auto state = state_;  // a listener may drop the last other copy,
  const Telling telling(*state);
  const std::size_t count = state->listeners.size();
  for (std::size_t i = 0; i < count; ++i) {  // may connect others, and disconnect, be it itself
    const Entry& entry = state->listeners[i];
    if (!entry.is_gone) entry.listener(emission);
  }
}

Emitter::Telling::~Telling() {
  if (--state_.telling > 0 || !std::exchange(state_.left_meanwhile, false)) return;
  std::vector<Listener> dropped;
  for (Entry& entry : state_.listeners) {
    if (entry.is_gone && entry.listener) dropped.push_back(std::exchange(entry.listener, {}));
  }
  forgetGone(state_);
}  // what they held goes last: it may lead here again

std::uint64_t Emitter::connect(Listener listener) const {
  const std::uint64_t link = state_->next_link++;
  state_->listeners.push_back({link, false, std::move(listener)});
  ++state_->count;
  tellChange();
  return link;
}

void Emitter::disconnect(std::uint64_t link) const {
  const auto state = state_;
  auto& listeners = state->listeners;
  const auto found = std::lower_bound(
      listeners.begin(), listeners.end(), link,
      [](const Entry& entry, std::uint64_t wanted) { return entry.link < wanted; });
  if (found == listeners.end() || found->link != link || found->is_gone) return;
  found->is_gone = true;
  --state->count;
  if (state->telling == 0) {
    const Listener dropped = std::exchange(found->listener, {});  // goes last: may lead here again
    forgetGone(*state);
  } else {
    state->left_meanwhile = true;
  }
  tellChange();
}

// Once half of the places are empty, so that each costs little.
void Emitter::forgetGone(State& state) {
  auto& listeners = state.listeners;
  if (listeners.size() <= 2 * state.count) return;
  listeners.erase(std::remove_if(listeners.begin(), listeners.end(),
                                 [](const Entry& entry) { return entry.is_gone; }),
                  listeners.end());
}

std::function<std::optional<Emitter>()> Emitter::weak() const {
  return [weak = std::weak_ptr<State>(state_)]() -> std::optional<Emitter> {
    auto state = weak.lock();
    if (!state) return std::nullopt;
    return Emitter(std::move(state));
  };
}

void Emitter::onListeners(std::function<void(std::size_t)> changed) const {
  state_->changed = std::move(changed);
}

Pending<void> Emitter::heard() const {
  return state_->heard ? *state_->heard : Pending<void>::done();
}

void Emitter::tellChange() const {
  if (state_->changed) state_->changed(state_->count);
}

}  // namespace nao::rpc
