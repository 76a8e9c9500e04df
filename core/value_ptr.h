#pragma once

#include <memory>
#include <utility>

namespace nao {

/// Owns an object of a family of classes and copies it with itself, so that what holds one stays a
/// plain value. T has `std::unique_ptr<T> clone() const`, a copy that shares nothing that changes.
template <class T>
class ValuePtr {
 public:
  ValuePtr() = default;
  template <class U>
  ValuePtr(std::unique_ptr<U> object) : object_(std::move(object)) {}  // NOLINT
  ValuePtr(std::nullptr_t) {}                                          // NOLINT

  ValuePtr(const ValuePtr& other) : object_(other.object_ ? other.object_->clone() : nullptr) {}
  ValuePtr(ValuePtr&&) noexcept = default;
  ValuePtr& operator=(const ValuePtr& other) { return *this = ValuePtr(other); }
  ValuePtr& operator=(ValuePtr&&) noexcept = default;

  T* get() const { return object_.get(); }
  T* operator->() const { return object_.get(); }
  T& operator*() const { return *object_; }
  explicit operator bool() const { return object_ != nullptr; }
  void reset() { object_.reset(); }

 private:
  std::unique_ptr<T> object_;
};

}  // namespace nao
