#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace nao::rpc {

class RemoteObject;
class Service;

/// The bytes of an image and the like: shared, so that passing a value on copies no pixels.
using Bytes = std::vector<std::uint8_t>;
using SharedBytes = std::shared_ptr<const Bytes>;

/// Something with methods, passed by value: ours, or one the client hosts. Both null: no object.
struct ObjectRef {
  std::shared_ptr<Service> local;
  std::shared_ptr<RemoteObject> remote;

  bool operator==(const ObjectRef& other) const {
    return local == other.local && remote == other.remote;
  }
};

/// Any value of the wire, with the exact type it came with. What stands where `m` was declared is
/// kept bare, so the items of a [m] are simply values; only `m` inside `m` is a Dynamic.
class Value {
 public:
  struct Void {
    bool operator==(const Void&) const { return true; }
  };
  /// A dynamic without type and content: the empty signature.
  struct Invalid {
    bool operator==(const Invalid&) const { return true; }
  };
  struct List {
    std::string element;  // signature of each item
    std::vector<Value> items;
    bool operator==(const List& other) const;
  };
  struct Map {
    std::string key;    // signature of each key
    std::string value;  // signature of each value
    std::vector<std::pair<Value, Value>> entries;
    bool operator==(const Map& other) const;
  };
  /// A tuple, or a named struct: then the signature carries <Name,field,...>.
  struct Tuple {
    std::string signature;
    std::vector<Value> items;
    bool operator==(const Tuple& other) const;
  };
  struct Optional {
    std::string element;
    std::vector<Value> item;  // none or one
    bool operator==(const Optional& other) const;
  };
  /// A dynamic that holds a dynamic.
  struct Dynamic {
    std::shared_ptr<const Value> inner;
    bool operator==(const Dynamic& other) const;
  };
  using Content =
      std::variant<Void, Invalid, bool, std::int8_t, std::uint8_t, std::int16_t, std::uint16_t,
                   std::int32_t, std::uint32_t, std::int64_t, std::uint64_t, float, double,
                   std::string, SharedBytes, List, Map, Tuple, Optional, Dynamic, ObjectRef>;

  /// Void. Numbers keep their C++ width: 1 is "i", 1.5F is "f", int64_t is "l".
  Value() = default;
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
  Value(T number) : content_(widthOf(number)) {}  // NOLINT: implicit, so that lists read well
  Value(std::string text) : content_(std::move(text)) {}                                  // NOLINT
  Value(const char* text) : content_(std::string(text)) {}                                // NOLINT
  Value(SharedBytes bytes) : content_(std::move(bytes)) {}                                // NOLINT
  Value(List list) : content_(std::move(list)) {}                                         // NOLINT
  Value(Map map) : content_(std::move(map)) {}                                            // NOLINT
  Value(Tuple tuple) : content_(std::move(tuple)) {}                                      // NOLINT
  Value(Optional optional) : content_(std::move(optional)) {}                             // NOLINT
  Value(ObjectRef object) : content_(std::move(object)) {}                                // NOLINT
  Value(std::shared_ptr<Service> object) : content_(ObjectRef{std::move(object), {}}) {}  // NOLINT

  static Value invalid();
  /// [m]: NaoQi's list of anything. Value::list({"HeadYaw", 0.5F}).
  static Value list(std::vector<Value> items);
  static Value listOf(std::string element, std::vector<Value> items);
  /// (T...): the types are those of the items.
  static Value tuple(std::vector<Value> items);
  /// A struct, or a tuple with declared types: Value::tuple("(si)<Pair,a,b>", {"x", 1}).
  static Value tuple(std::string signature, std::vector<Value> items);
  static Value raw(Bytes bytes);
  /// A dynamic that holds `inner` as a dynamic.
  static Value dynamic(Value inner);

  std::string signature() const;
  const Content& content() const { return content_; }

  /// The value inside any number of Dynamics.
  const Value& bare() const;

  bool isVoid() const;
  bool isNumber() const;  // any int or float, not bool
  bool isString() const;
  bool isList() const;  // list or tuple

  /// The content by kind, looking into Dynamics: null if it is of another kind.
  template <class T>
  const T* find() const {
    return std::get_if<T>(&bare().content_);
  }
  const std::string* findText() const { return find<std::string>(); }
  const std::vector<Value>* findItems() const;       // of a list or a tuple
  std::optional<std::vector<Value>> takeItems() &&;  // the same, moved where nobody shares them
  std::optional<double> findNumber() const;          // of any int, float or bool
  SharedBytes findBytes() const;

  /// As the C++ type T, as loosely as NaoQi's ALValue: a tuple is a list, one value is a list of
  /// one, ints and floats and 0/1 as bool are one; a string is never a number.
  /// @throws CallError if it can not be. Defined in naoqi_api/convert.h.
  template <class T>
  T to() const;

  /// For logs and error texts: [1, "x", 2.5].
  std::string print() const;

  bool operator==(const Value& other) const { return content_ == other.content_; }
  bool operator!=(const Value& other) const { return !(*this == other); }

 private:
  template <class T>
  static Content widthOf(T number) {
    if constexpr (std::is_same_v<T, bool> || std::is_floating_point_v<T>) {
      return number;
    } else if constexpr (std::is_signed_v<T>) {
      if constexpr (sizeof(T) == 1) return static_cast<std::int8_t>(number);
      if constexpr (sizeof(T) == 2) return static_cast<std::int16_t>(number);
      if constexpr (sizeof(T) == 4) return static_cast<std::int32_t>(number);
      if constexpr (sizeof(T) == 8) return static_cast<std::int64_t>(number);
    } else {
      if constexpr (sizeof(T) == 1) return static_cast<std::uint8_t>(number);
      if constexpr (sizeof(T) == 2) return static_cast<std::uint16_t>(number);
      if constexpr (sizeof(T) == 4) return static_cast<std::uint32_t>(number);
      if constexpr (sizeof(T) == 8) return static_cast<std::uint64_t>(number);
    }
  }

  Content content_;
};

}  // namespace nao::rpc
