#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "naoqi_api/signature.h"
#include "naoqi_api/value.h"

namespace nao::wire {

/// Builds a value from what a parser meets, in its order; refuses what is nested too deep or has
/// too many parts. Each step is false from the first refusal on.
class ValueBuilder {
 public:
  static constexpr std::size_t kMaxValues = 1U << 20U;

  bool put(rpc::Value value) {
    if (failed_ || ++values_ > kMaxValues) return fail();
    if (open_.empty()) {
      result_ = std::move(value);
      is_whole_ = true;
    } else {
      open_.back().push_back(std::move(value));
    }
    return true;
  }

  /// As the smallest of i, l and L that holds it.
  bool putInteger(std::int64_t number) {
    const auto small = static_cast<std::int32_t>(number);
    return small == number ? put(small) : put(number);
  }
  bool putInteger(std::uint64_t number) {
    constexpr auto kMost = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    return number <= kMost ? putInteger(static_cast<std::int64_t>(number)) : put(number);
  }

  /// What is put from here on goes into a list, or into a map as key, value, key, value.
  bool open() {
    if (failed_ || open_.size() >= rpc::kMaxNesting) return fail();
    open_.emplace_back();
    return true;
  }
  bool closeList() {
    if (failed_) return false;
    return put(rpc::Value::list(take()));
  }
  /// @param key the type of its keys: "s" or "m"
  bool closeMap(const char* key) {
    if (failed_) return false;
    auto items = take();
    rpc::Value::Map map{key, "m", {}};
    for (std::size_t i = 0; i + 1 < items.size(); i += 2) {
      map.entries.emplace_back(std::move(items[i]), std::move(items[i + 1]));
    }
    return put(rpc::Value(std::move(map)));
  }

  bool fail() {
    failed_ = true;
    return false;
  }
  bool hasFailed() const { return failed_; }
  /// Of the value that is being built, and what it is a part of.
  std::size_t valueCount() const { return values_ + open_.size(); }
  bool isWhole() const { return is_whole_ && !failed_; }

  rpc::Value takeResult() {
    values_ = 0;
    is_whole_ = false;
    return std::exchange(result_, rpc::Value());
  }

 private:
  std::vector<rpc::Value> take() {
    auto items = std::move(open_.back());
    open_.pop_back();
    return items;
  }

  std::vector<std::vector<rpc::Value>> open_;
  rpc::Value result_;
  std::size_t values_ = 0;
  bool is_whole_ = false;
  bool failed_ = false;
};

}  // namespace nao::wire
