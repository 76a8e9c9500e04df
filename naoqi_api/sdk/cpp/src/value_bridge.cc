#include "naoqi_api/sdk/cpp/src/value_bridge.h"

#include <type_traits>
#include <utility>
#include <variant>

namespace nao::client {
namespace {

using AL::ALValue;
using rpc::Value;

ALValue arrayOf(const std::vector<Value>& items) {
  ALValue array;
  array.arraySetSize(static_cast<int>(items.size()));
  for (std::size_t i = 0; i < items.size(); ++i) array[static_cast<int>(i)] = fromWire(items[i]);
  return array;
}

struct ToProgram {
  ALValue operator()(const Value::Void& /*none*/) const { return {}; }
  ALValue operator()(const Value::Invalid& /*none*/) const { return {}; }
  ALValue operator()(const rpc::ObjectRef& /*object*/) const { return {}; }
  ALValue operator()(bool truth) const { return truth; }
  template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
  ALValue operator()(T number) const {
    if constexpr (std::is_floating_point_v<T>) return static_cast<float>(number);
    return static_cast<int>(number);
  }
  ALValue operator()(const std::string& text) const { return text; }
  ALValue operator()(const rpc::SharedBytes& bytes) const {
    ALValue binary;
    binary.SetBinary(std::shared_ptr<const void>(bytes, bytes->data()),
                     static_cast<int>(bytes->size()));
    return binary;
  }
  ALValue operator()(const Value::List& list) const { return arrayOf(list.items); }
  ALValue operator()(const Value::Tuple& tuple) const { return arrayOf(tuple.items); }
  ALValue operator()(const Value::Map& map) const {
    ALValue array;
    array.arraySetSize(0);
    for (const auto& [key, value] : map.entries) {
      array.arrayPush(ALValue::array(fromWire(key), fromWire(value)));
    }
    return array;
  }
  ALValue operator()(const Value::Optional& optional) const {
    return optional.item.empty() ? ALValue() : fromWire(optional.item.front());
  }
  ALValue operator()(const Value::Dynamic& dynamic) const { return fromWire(*dynamic.inner); }
};

Value listOf(const ALValue& array) {
  std::vector<Value> items;
  items.reserve(array.getSize());
  for (unsigned int i = 0; i < array.getSize(); ++i) {
    items.push_back(toWire(array[static_cast<int>(i)]));
  }
  return Value::list(std::move(items));
}

}  // namespace

Value toWire(const ALValue& value) {
  switch (value.getType()) {
    case ALValue::TypeArray:
      return listOf(value);
    case ALValue::TypeBool:
      return static_cast<bool>(value);
    case ALValue::TypeInt:
      return static_cast<int>(value);
    case ALValue::TypeFloat:
      return static_cast<float>(value);
    case ALValue::TypeString:
      return static_cast<const std::string&>(value);
    case ALValue::TypeBinary: {
      const auto* bytes = static_cast<const std::uint8_t*>(value.GetBinary());
      return Value::raw({bytes, bytes + value.getSize()});
    }
    case ALValue::TypeInvalid:
    case ALValue::TypeObject:
      break;
  }
  return {};
}

ALValue fromWire(const Value& value) { return std::visit(ToProgram(), value.content()); }

}  // namespace nao::client
