#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace nao {

/// Hands the newest value from one writer to any number of readers; older values are dropped.
/// A value, once published, is never modified, so readers keep it without a lock.
template <class T>
class Latest {
 public:
  void publish(T value) { publish(std::make_shared<const T>(std::move(value))); }

  void publish(std::shared_ptr<const T> value) {
    const std::lock_guard lock(mutex_);  // held for a pointer swap only
    value_.swap(value);
  }

  /// The newest value, or null before the first publish().
  std::shared_ptr<const T> get() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const T> value_;
};

}  // namespace nao
