#pragma once

#include <cstddef>
#include <memory>
#include <utility>

namespace nao::daemon {

/// What all clients together may leave lying here: beginnings of messages, and answers that they do
/// not fetch. Once that is too much, who leaves more than a little is closed. I/O thread.
class ByteBudget {
 public:
  static constexpr std::size_t kMost = 256U << 20U;
  static constexpr std::size_t kLittle = 256U << 10U;  // of one client

  /// A client leaves `now` bytes instead of `before`. False: it is to be closed.
  [[nodiscard]] bool change(std::size_t before, std::size_t now) {
    used_ += now;
    used_ -= before;
    return used_ <= kMost || now <= kLittle || now < before;
  }

  std::size_t used() const { return used_; }

 private:
  std::size_t used_ = 0;
};

/// What one client leaves lying, given back when it goes.
class BudgetShare {
 public:
  explicit BudgetShare(std::shared_ptr<ByteBudget> budget) : budget_(std::move(budget)) {}
  ~BudgetShare() { (void)change(0); }
  BudgetShare(const BudgetShare&) = delete;
  BudgetShare& operator=(const BudgetShare&) = delete;

  /// It leaves `now` bytes. False: it is to be closed.
  [[nodiscard]] bool change(std::size_t now) {
    return budget_->change(std::exchange(bytes_, now), now);
  }
  std::size_t bytes() const { return bytes_; }

 private:
  std::shared_ptr<ByteBudget> budget_;
  std::size_t bytes_ = 0;
};

}  // namespace nao::daemon
