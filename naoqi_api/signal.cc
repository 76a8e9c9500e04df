#include "naoqi_api/signal.h"

namespace nao::rpc {

Emitter::Emitter(std::string signature) : state_(std::make_shared<State>()) {
  state_->signature = std::move(signature);
}

void Emitter::emit(const std::vector<Value>& arguments) const {
  const auto state = state_;                // a listener may drop the last other copy,
  const auto listeners = state->listeners;  // and may connect or disconnect
  for (const auto& [link, listener] : listeners) {
    if (state->listeners.count(link) > 0) listener(arguments);
  }
}

std::uint64_t Emitter::connect(Listener listener) const {
  const std::uint64_t link = state_->next_link++;
  state_->listeners[link] = std::move(listener);
  tellChange();
  return link;
}

void Emitter::disconnect(std::uint64_t link) const {
  if (state_->listeners.erase(link) > 0) tellChange();
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

void Emitter::tellChange() const {
  if (state_->changed) state_->changed(state_->listeners.size());
}

}  // namespace nao::rpc
