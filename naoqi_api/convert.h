#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "naoqi_api/call_error.h"
#include "naoqi_api/fits.h"
#include "naoqi_api/pending.h"
#include "naoqi_api/signature.h"
#include "naoqi_api/value.h"

namespace nao::rpc {

/// NaoQi's habit of taking either one value or a list of them. Signature "m".
template <class T>
struct OneOrMany : std::vector<T> {
  using std::vector<T>::vector;
};

/// How far a value may be bent to fit a type.
enum class Bend {
  Declared,  // a concrete declared type, as libqi does it: numbers in range, [m] to [s], ...
  Loose,     // inside `m`, as ALValue does it: also a tuple as a list, one value as a list of one
};

/// `value` as a value of exactly the type `signature`, or nothing if it can not be that.
/// Numbers change width if in range, floats become ints by truncation, 0 and 1 bools; text never
/// becomes a number or the reverse.
std::optional<Value> convert(const Value& value, const Signature& signature, Bend bend);

/// How a C++ type travels: its signature, and how to make and read a Value of it. Specialise it
/// for a struct of your own (see naoqi_api/services/service_info.h). read() is given a value of
/// exactly that signature.
template <class T>
struct ValueType;

/// The qi signature of a C++ type: double is "d", vector<string> is "[s]", Pending<T> is T's.
template <class T>
std::string signatureOf() {
  return ValueType<std::decay_t<T>>::signature();
}
template <class T>
Value toValue(const T& value) {
  return ValueType<T>::make(value);
}

/// The same, parsed once.
template <class T>
const Signature& typeOf() {
  static const Signature type = Signature::of(signatureOf<T>());
  return type;
}

template <class T>
T Value::to() const {
  const Signature& wanted = typeOf<T>();
  if (fits(*this, wanted)) return ValueType<T>::read(*this);
  const auto fitting = convert(*this, wanted, Bend::Loose);
  if (!fitting) throw CallError("expected " + wanted.words() + ", got " + print());
  return ValueType<T>::read(*fitting);
}

// The types that Value holds as they are.
template <class T, char kLetter>
struct PlainType {
  static std::string signature() { return std::string(1, kLetter); }
  static Value make(const T& value) { return Value(value); }
  static T read(const Value& value) { return std::get<T>(value.content()); }
};
template <>
struct ValueType<bool> : PlainType<bool, 'b'> {};
template <>
struct ValueType<std::int8_t> : PlainType<std::int8_t, 'c'> {};
template <>
struct ValueType<std::uint8_t> : PlainType<std::uint8_t, 'C'> {};
template <>
struct ValueType<std::int16_t> : PlainType<std::int16_t, 'w'> {};
template <>
struct ValueType<std::uint16_t> : PlainType<std::uint16_t, 'W'> {};
template <>
struct ValueType<std::int32_t> : PlainType<std::int32_t, 'i'> {};
template <>
struct ValueType<std::uint32_t> : PlainType<std::uint32_t, 'I'> {};
template <>
struct ValueType<std::int64_t> : PlainType<std::int64_t, 'l'> {};
template <>
struct ValueType<std::uint64_t> : PlainType<std::uint64_t, 'L'> {};
template <>
struct ValueType<float> : PlainType<float, 'f'> {};
template <>
struct ValueType<double> : PlainType<double, 'd'> {};
template <>
struct ValueType<std::string> : PlainType<std::string, 's'> {};
template <>
struct ValueType<SharedBytes> : PlainType<SharedBytes, 'r'> {};
template <>
struct ValueType<ObjectRef> : PlainType<ObjectRef, 'o'> {};

template <>
struct ValueType<void> {
  static std::string signature() { return "v"; }
};
template <>
struct ValueType<Value> {
  static std::string signature() { return "m"; }
  static Value make(const Value& value) { return value; }
  static const Value& read(const Value& value) { return value; }
};
template <>
struct ValueType<std::shared_ptr<Service>> {
  static std::string signature() { return "o"; }
  static Value make(const std::shared_ptr<Service>& object) { return Value(object); }
};
template <class T>
struct ValueType<Pending<T>> : ValueType<T> {};

template <class T>
struct ValueType<std::vector<T>> {
  static std::string signature() { return "[" + signatureOf<T>() + "]"; }
  static Value make(const std::vector<T>& items) {
    std::vector<Value> values;
    values.reserve(items.size());
    for (const auto& item : items) values.push_back(toValue<T>(item));
    return Value::listOf(signatureOf<T>(), std::move(values));
  }
  static std::vector<T> read(const Value& value) {
    std::vector<T> items;
    for (const Value& item : *value.findItems()) items.push_back(ValueType<T>::read(item));
    return items;
  }
};

template <class T>
struct ValueType<OneOrMany<T>> {
  static std::string signature() { return "m"; }
  static Value make(const OneOrMany<T>& items) { return ValueType<std::vector<T>>::make(items); }
  static OneOrMany<T> read(const Value& value) {
    OneOrMany<T> items;
    static_cast<std::vector<T>&>(items) = value.to<std::vector<T>>();
    return items;
  }
};

template <class K, class V>
struct ValueType<std::map<K, V>> {
  static std::string signature() { return "{" + signatureOf<K>() + signatureOf<V>() + "}"; }
  static Value make(const std::map<K, V>& map) {
    Value::Map made{signatureOf<K>(), signatureOf<V>(), {}};
    for (const auto& [key, value] : map) made.entries.emplace_back(toValue(key), toValue(value));
    return made;
  }
  static std::map<K, V> read(const Value& value) {
    std::map<K, V> map;
    for (const auto& [key, mapped] : value.find<Value::Map>()->entries) {
      map.insert_or_assign(ValueType<K>::read(key), ValueType<V>::read(mapped));
    }
    return map;
  }
};

template <class... T>
struct ValueType<std::tuple<T...>> {
  static std::string signature() { return "(" + (signatureOf<T>() + ... + std::string()) + ")"; }
  static Value make(const std::tuple<T...>& tuple) {
    return std::apply(
        [](const T&... item) { return Value::tuple(signature(), {toValue(item)...}); }, tuple);
  }
  static std::tuple<T...> read(const Value& value) {
    return readItems(*value.findItems(), std::index_sequence_for<T...>());
  }
  template <std::size_t... kIndex>
  static std::tuple<T...> readItems([[maybe_unused]] const std::vector<Value>& items,
                                    std::index_sequence<kIndex...> /*all*/) {
    return {ValueType<T>::read(items[kIndex])...};
  }
};

}  // namespace nao::rpc
