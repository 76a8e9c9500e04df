#pragma once

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include <Eigen/Core>

#include "core/check.h"

namespace nao {

/// Saves, restores or hashes a state that is listed once: whoever owns state lists it in one
/// `void archive(Archive&)`, in a fixed order, and has all three. Restoring into an object made
/// alike goes on bit by bit. Lists must have the same length when restored.
class Archive {
 public:
  enum class Mode { Save, Load, Hash };

  static Archive saving(std::vector<unsigned char>& bytes) { return {Mode::Save, &bytes, nullptr}; }
  static Archive loading(const std::vector<unsigned char>& bytes) {
    return {Mode::Load, nullptr, &bytes};
  }
  static Archive hashing() { return {Mode::Hash, nullptr, nullptr}; }

  Mode mode() const { return mode_; }
  std::uint64_t hash() const { return hash_; }
  /// True once a restore has read all there was.
  bool atEnd() const { return source_ && position_ == source_->size(); }

  /// A number, flag, enum or a struct of such without padding.
  template <class T>
  void value(T& v) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes(&v, sizeof v);
  }
  /// A vector or matrix of numbers, of the same size whenever restored.
  template <class Derived>
  void numbers(Eigen::PlainObjectBase<Derived>& v) {
    bytes(v.data(), static_cast<std::size_t>(v.size()) * sizeof(typename Derived::Scalar));
  }
  /// A list of plain values; its length is restored too.
  template <class T>
  void list(std::vector<T>& items) {
    static_assert(std::is_trivially_copyable_v<T>);
    auto count = static_cast<std::uint64_t>(items.size());
    value(count);
    if (mode_ == Mode::Load) items.resize(static_cast<std::size_t>(count));
    bytes(items.data(), items.size() * sizeof(T));
  }
  /// A list of structs, each listed by `one(item)`; its length is restored too.
  template <class T, class F>
  void each(std::vector<T>& items, F one) {
    auto count = static_cast<std::uint64_t>(items.size());
    value(count);
    if (mode_ == Mode::Load) items.resize(static_cast<std::size_t>(count));
    for (T& item : items) one(item);
  }

 private:
  Archive(Mode mode, std::vector<unsigned char>* out, const std::vector<unsigned char>* in)
      : mode_(mode), target_(out), source_(in) {}

  void bytes(void* data, std::size_t size);

  Mode mode_;
  std::vector<unsigned char>* target_;
  const std::vector<unsigned char>* source_;
  std::size_t position_ = 0;
  std::uint64_t hash_ = 14695981039346656037ULL;
};

}  // namespace nao
