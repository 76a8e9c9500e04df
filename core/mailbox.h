#pragma once

#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace nao {

/// A bounded queue from many senders to the one thread that drains it.
template <class T>
class Mailbox {
 public:
  explicit Mailbox(std::size_t capacity) : capacity_(capacity) {}

  /// False when full: the sender must report "busy", never wait.
  [[nodiscard]] bool post(T message) {
    const std::lock_guard lock(mutex_);
    if (messages_.size() == capacity_) return false;
    messages_.push_back(std::move(message));
    return true;
  }

  /// Takes every message, in order; the lock is held only for a swap.
  std::vector<T> drain() {
    std::vector<T> taken;
    const std::lock_guard lock(mutex_);
    taken.swap(messages_);
    return taken;
  }

 private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::vector<T> messages_;
};

}  // namespace nao
