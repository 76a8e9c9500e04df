#include "naoqi_api/convert.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nao::rpc {
namespace {

// Integers wide enough for every kind: a magnitude and a sign.
struct Integer {
  bool negative = false;
  std::uint64_t magnitude = 0;
};

std::optional<Integer> integerOf(const Value& value) {
  return std::visit(
      [](const auto& content) -> std::optional<Integer> {
        using T = std::decay_t<decltype(content)>;
        if constexpr (std::is_same_v<T, bool>) {
          return Integer{false, content ? 1U : 0U};
        } else if constexpr (std::is_floating_point_v<T>) {
          if (std::isnan(content)) return Integer{};  // as libqi does
          const double whole = std::trunc(static_cast<double>(content));
          if (std::abs(whole) >= 0x1p64) return std::nullopt;
          return Integer{whole < 0, static_cast<std::uint64_t>(std::abs(whole))};
        } else if constexpr (std::is_integral_v<T>) {
          const bool negative = content < T{0};
          const auto bits = static_cast<std::uint64_t>(content);
          return Integer{negative, negative ? ~bits + 1 : bits};
        } else {
          return std::nullopt;
        }
      },
      value.content());
}

template <class T>
std::optional<Value> toInteger(const Value& value) {
  const auto integer = integerOf(value);
  if (!integer) return std::nullopt;
  constexpr auto kMax = static_cast<std::uint64_t>(std::numeric_limits<T>::max());
  if (!integer->negative) {
    if (integer->magnitude > kMax) return std::nullopt;
    return Value(static_cast<T>(integer->magnitude));
  }
  if (std::is_unsigned_v<T> || integer->magnitude > kMax + 1) return std::nullopt;
  return Value(static_cast<T>(~integer->magnitude + 1));
}

std::optional<Value> toBool(const Value& value) {
  if (value.find<bool>()) return value;
  const auto number = value.findNumber();
  if (number != 0.0 && number != 1.0) return std::nullopt;
  return Value(number == 1.0);
}

template <class T>
std::optional<Value> toFloating(const Value& value) {
  const auto number = value.findNumber();
  if (!number) return std::nullopt;
  constexpr double kMax = static_cast<double>(std::numeric_limits<T>::max());
  if (std::isfinite(*number) && std::abs(*number) > kMax) return std::nullopt;
  return Value(static_cast<T>(*number));
}

std::optional<std::vector<Value>> convertEach(const std::vector<Value>& items,
                                              const Signature& type, Bend bend) {
  std::vector<Value> converted;
  converted.reserve(items.size());
  for (const Value& item : items) {
    auto fitting = convert(item, type, bend);
    if (!fitting) return std::nullopt;
    converted.push_back(*std::move(fitting));
  }
  return converted;
}

std::optional<Value> toList(const Value& value, const Signature& type, Bend bend) {
  const Signature& element = type.children().front();
  std::optional<std::vector<Value>> items;
  if (const auto* list = value.find<Value::List>()) {
    items = convertEach(list->items, element, bend);
  } else if (bend == Bend::Loose && value.isList()) {
    items = convertEach(*value.findItems(), element, bend);
  } else if (bend == Bend::Loose && !value.isVoid()) {
    items = convertEach({value}, element, bend);
  }
  if (!items) return std::nullopt;
  return Value::listOf(element.text(), *std::move(items));
}

std::optional<Value> toMap(const Value& value, const Signature& type, Bend bend) {
  const auto* map = value.find<Value::Map>();
  if (!map) return std::nullopt;
  const Signature& key_type = type.children()[0];
  const Signature& value_type = type.children()[1];
  Value::Map converted{key_type.text(), value_type.text(), {}};
  for (const auto& [key, mapped] : map->entries) {
    auto fitting_key = convert(key, key_type, bend);
    auto fitting_value = convert(mapped, value_type, bend);
    if (!fitting_key || !fitting_value) return std::nullopt;
    converted.entries.emplace_back(*std::move(fitting_key), *std::move(fitting_value));
  }
  return Value(std::move(converted));
}

// "Name,first,second" cut at the commas.
std::vector<std::string> splitAnnotation(const std::string& annotation) {
  std::vector<std::string> names(1);
  for (char letter : annotation) {
    if (letter == ',') {
      names.emplace_back();
    } else {
      names.back() += letter;
    }
  }
  return names;
}

std::optional<Value> defaultOf(const Signature& type) {
  if (type.is('s')) return Value(std::string());
  if (type.is('[')) return Value::listOf(type.children().front().text(), {});
  return convert(Value(0), type, Bend::Declared);
}

// Structs of one name from different versions: fields meet by name, new ones are empty or zero.
std::optional<Value> toStruct(const std::vector<Value>& items, const std::string& annotation,
                              const Signature& type, Bend bend) {
  const auto given = splitAnnotation(annotation);
  const auto wanted = splitAnnotation(type.annotation());
  if (given.front() != wanted.front() || given.size() != items.size() + 1 ||
      wanted.size() != type.children().size() + 1) {
    return std::nullopt;
  }
  std::vector<Value> converted;
  for (std::size_t i = 1; i < wanted.size(); ++i) {
    const auto found = std::find(given.begin() + 1, given.end(), wanted[i]);
    const Signature& field = type.children()[i - 1];
    auto fitting = found == given.end() ? defaultOf(field)
                                        : convert(items[found - given.begin() - 1], field, bend);
    if (!fitting) return std::nullopt;
    converted.push_back(*std::move(fitting));
  }
  return Value::tuple(type.text(), std::move(converted));
}

std::optional<Value> toTuple(const Value& value, const Signature& type, Bend bend) {
  const auto* items = value.findItems();
  if (!items) return std::nullopt;
  if (items->size() != type.children().size()) {
    const auto given = Signature::parse(value.signature());
    if (!given || given->annotation().empty()) return std::nullopt;
    return toStruct(*items, given->annotation(), type, bend);
  }
  std::vector<Value> converted;
  for (std::size_t i = 0; i < items->size(); ++i) {
    auto fitting = convert((*items)[i], type.children()[i], bend);
    if (!fitting) return std::nullopt;
    converted.push_back(*std::move(fitting));
  }
  return Value::tuple(type.text(), std::move(converted));
}

std::optional<Value> toOptional(const Value& value, const Signature& type, Bend bend) {
  const Signature& element = type.children().front();
  std::optional<std::vector<Value>> item = std::vector<Value>();
  if (const auto* optional = value.find<Value::Optional>()) {
    item = convertEach(optional->item, element, bend);
  } else if (!value.isVoid()) {
    item = convertEach({value}, element, bend);
  }
  if (!item) return std::nullopt;
  return Value(Value::Optional{element.text(), *std::move(item)});
}

std::optional<Value> toBytes(const Value& value) {
  if (value.findBytes()) return value;
  if (const auto* text = value.findText()) return Value::raw(Bytes(text->begin(), text->end()));
  return std::nullopt;
}

template <class T>
std::optional<Value> ifIs(const Value& value) {
  return value.find<T>() ? std::optional<Value>(value) : std::nullopt;
}

}  // namespace

std::optional<Value> convert(const Value& value, const Signature& signature, Bend bend) {
  if (signature.is('m')) return value;
  const Value& bare = value.bare();
  switch (signature.kind()) {
    case 'b':
      return toBool(bare);
    case 'c':
      return toInteger<std::int8_t>(bare);
    case 'C':
      return toInteger<std::uint8_t>(bare);
    case 'w':
      return toInteger<std::int16_t>(bare);
    case 'W':
      return toInteger<std::uint16_t>(bare);
    case 'i':
      return toInteger<std::int32_t>(bare);
    case 'I':
      return toInteger<std::uint32_t>(bare);
    case 'l':
      return toInteger<std::int64_t>(bare);
    case 'L':
      return toInteger<std::uint64_t>(bare);
    case 'f':
      return toFloating<float>(bare);
    case 'd':
      return toFloating<double>(bare);
    case 's':
      return ifIs<std::string>(bare);
    case 'r':
      return toBytes(bare);
    case 'o':
      return ifIs<ObjectRef>(bare);
    case 'v':
      return ifIs<Value::Void>(bare);
    case '[':
    case '#':
      return toList(bare, signature, bend);
    case '{':
      return toMap(bare, signature, bend);
    case '(':
      return toTuple(bare, signature, bend);
    case '+':
      return toOptional(bare, signature, bend);
    default:
      return std::nullopt;
  }
}

}  // namespace nao::rpc
