#include "naoqi_api/session.h"

namespace nao::rpc {

Session::~Session() { end(); }

std::uint64_t Session::onEnd(std::function<void()> ended) {
  const std::uint64_t link = next_link_++;
  ended_[link] = std::move(ended);
  return link;
}

void Session::end() {
  const auto callbacks = std::exchange(ended_, {});
  for (const auto& [link, ended] : callbacks) ended();
}

}  // namespace nao::rpc
