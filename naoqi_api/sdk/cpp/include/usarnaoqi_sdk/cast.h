#pragma once

#include <string>
#include <vector>

#include <alvalue/alvalue.h>

namespace AL {
namespace detail {

/// What ALValue becomes where a method returns a T.
template <class T>
struct Cast {
  static T of(const ALValue& value) { return static_cast<T>(value); }
};
template <>
struct Cast<void> {
  static void of(const ALValue&) {}
};
template <>
struct Cast<ALValue> {
  static const ALValue& of(const ALValue& value) { return value; }
};
template <class T>
struct Cast<std::vector<T> > {
  static std::vector<T> of(const ALValue& value) {
    std::vector<T> items;
    if (!value.isArray()) return items.push_back(Cast<T>::of(value)), items;
    for (unsigned int i = 0; i < value.getSize(); ++i) {
      items.push_back(Cast<T>::of(value[static_cast<int>(i)]));
    }
    return items;
  }
};

/// How a parameter or result type of a bound method is named on the wire.
template <class T>
struct WireType;
template <>
struct WireType<void> {
  static std::string name() { return "v"; }
};
template <>
struct WireType<bool> {
  static std::string name() { return "b"; }
};
template <>
struct WireType<int> {
  static std::string name() { return "i"; }
};
template <>
struct WireType<float> {
  static std::string name() { return "f"; }
};
template <>
struct WireType<double> {
  static std::string name() { return "d"; }
};
template <>
struct WireType<std::string> {
  static std::string name() { return "s"; }
};
template <>
struct WireType<ALValue> {
  static std::string name() { return "m"; }
};
template <class T>
struct WireType<std::vector<T> > {
  static std::string name() { return "[" + WireType<T>::name() + "]"; }
};

/// const std::string& and the like: the type itself.
template <class T>
struct Bare {
  typedef T type;
};
template <class T>
struct Bare<const T> {
  typedef T type;
};
template <class T>
struct Bare<T&> {
  typedef typename Bare<T>::type type;
};

}  // namespace detail
}  // namespace AL
