#pragma once

#include <list>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace nao {

/// The results of a slow function, by key; the newest `most` are kept. Any thread may ask; two that
/// ask for the same new key at once both compute it, to the same result.
template <class T>
class Memo {
 public:
  explicit Memo(std::size_t most) : most_(most) {}

  template <class Compute>
  std::shared_ptr<const T> get(const std::string& key, Compute compute) {
    if (auto known = find(key)) return known;
    auto made = std::make_shared<const T>(compute());
    const std::lock_guard lock(mutex_);
    kept_.emplace_front(key, made);
    if (kept_.size() > most_) kept_.pop_back();
    return made;
  }

 private:
  std::shared_ptr<const T> find(const std::string& key) {
    const std::lock_guard lock(mutex_);
    for (auto at = kept_.begin(); at != kept_.end(); ++at) {
      if (at->first != key) continue;
      kept_.splice(kept_.begin(), kept_, at);
      return kept_.front().second;
    }
    return nullptr;
  }

  const std::size_t most_;
  std::mutex mutex_;
  std::list<std::pair<std::string, std::shared_ptr<const T>>> kept_;
};

}  // namespace nao
