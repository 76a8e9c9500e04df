#pragma once

#include <cstdint>

namespace nao::daemon {

/// Decides when the clock of a message that has begun and not ended starts, goes on, and stops. A
/// client that is not being read can not be blamed, nor one whose messages keep coming.
class HalfMessage {
 public:
  enum class Clock { Restart, GoOn, Stop };

  /// To be told after every read: whether half a message is there, whether the connection leaves
  /// messages unread on purpose, and how many it has taken so far.
  Clock look(bool holds_half, bool held, std::uint64_t messages_taken) {
    const bool moved = messages_taken != messages_taken_;
    messages_taken_ = messages_taken;
    if (!holds_half || held) {
      running_ = false;
      return Clock::Stop;
    }
    if (running_ && !moved) return Clock::GoOn;
    running_ = true;
    return Clock::Restart;
  }

 private:
  bool running_ = false;
  std::uint64_t messages_taken_ = 0;
};

}  // namespace nao::daemon
