#include "naoqi_api/value.h"

#include <sstream>

#include "core/check.h"
#include "naoqi_api/call_error.h"

namespace nao::rpc {
namespace {

template <class... F>
struct Overload : F... {
  using F::operator()...;
};
template <class... F>
Overload(F...) -> Overload<F...>;

struct SignatureOf {
  std::string operator()(const Value::Void& /*none*/) const { return "v"; }
  std::string operator()(const Value::Invalid& /*none*/) const { return ""; }
  std::string operator()(bool /*value*/) const { return "b"; }
  std::string operator()(std::int8_t /*value*/) const { return "c"; }
  std::string operator()(std::uint8_t /*value*/) const { return "C"; }
  std::string operator()(std::int16_t /*value*/) const { return "w"; }
  std::string operator()(std::uint16_t /*value*/) const { return "W"; }
  std::string operator()(std::int32_t /*value*/) const { return "i"; }
  std::string operator()(std::uint32_t /*value*/) const { return "I"; }
  std::string operator()(std::int64_t /*value*/) const { return "l"; }
  std::string operator()(std::uint64_t /*value*/) const { return "L"; }
  std::string operator()(float /*value*/) const { return "f"; }
  std::string operator()(double /*value*/) const { return "d"; }
  std::string operator()(const std::string& /*value*/) const { return "s"; }
  std::string operator()(const SharedBytes& /*value*/) const { return "r"; }
  std::string operator()(const Value::List& list) const { return "[" + list.element + "]"; }
  std::string operator()(const Value::Map& map) const { return "{" + map.key + map.value + "}"; }
  std::string operator()(const Value::Tuple& tuple) const { return tuple.signature; }
  std::string operator()(const Value::Optional& optional) const { return "+" + optional.element; }
  std::string operator()(const Value::Dynamic& /*value*/) const { return "m"; }
  std::string operator()(const ObjectRef& /*object*/) const { return "o"; }
};

void print(std::ostream& out, const Value& value);

void printItems(std::ostream& out, const std::vector<Value>& items, char open, char close) {
  out << open;
  for (std::size_t i = 0; i < items.size() && i < 20; ++i) {
    if (i > 0) out << ", ";
    print(out, items[i]);
  }
  if (items.size() > 20) out << ", ...";
  out << close;
}

void print(std::ostream& out, const Value& value) {
  std::visit(Overload{
                 [&](const Value::Void& /*none*/) { out << "nothing"; },
                 [&](const Value::Invalid& /*none*/) { out << "invalid"; },
                 [&](bool truth) { out << (truth ? "true" : "false"); },
                 [&](std::int8_t number) { out << static_cast<int>(number); },
                 [&](std::uint8_t number) { out << static_cast<int>(number); },
                 [&](const std::string& text) { out << '"' << text.substr(0, 80) << '"'; },
                 [&](const SharedBytes& bytes) { out << (bytes ? bytes->size() : 0) << " bytes"; },
                 [&](const Value::List& list) { printItems(out, list.items, '[', ']'); },
                 [&](const Value::Map& map) { out << "map of " << map.entries.size(); },
                 [&](const Value::Tuple& tuple) { printItems(out, tuple.items, '(', ')'); },
                 [&](const Value::Optional& optional) { printItems(out, optional.item, '<', '>'); },
                 [&](const Value::Dynamic& dynamic) { print(out, *dynamic.inner); },
                 [&](const ObjectRef& /*object*/) { out << "object"; },
                 [&](auto number) { out << number; },
             },
             value.content());
}

}  // namespace

bool Value::List::operator==(const List& other) const {
  return element == other.element && items == other.items;
}
bool Value::Map::operator==(const Map& other) const {
  return key == other.key && value == other.value && entries == other.entries;
}
bool Value::Tuple::operator==(const Tuple& other) const {
  return signature == other.signature && items == other.items;
}
bool Value::Optional::operator==(const Optional& other) const {
  return element == other.element && item == other.item;
}
bool Value::Dynamic::operator==(const Dynamic& other) const { return *inner == *other.inner; }

Value Value::invalid() {
  Value value;
  value.content_ = Invalid{};
  return value;
}

Value Value::list(std::vector<Value> items) { return listOf("m", std::move(items)); }

Value Value::listOf(std::string element, std::vector<Value> items) {
  return List{std::move(element), std::move(items)};
}

Value Value::tuple(std::vector<Value> items) {
  std::string signature = "(";
  for (const Value& item : items) signature += item.signature();
  return tuple(signature + ")", std::move(items));
}

Value Value::tuple(std::string signature, std::vector<Value> items) {
  return Tuple{std::move(signature), std::move(items)};
}

Value Value::raw(Bytes bytes) { return std::make_shared<const Bytes>(std::move(bytes)); }

Value Value::dynamic(Value inner) {
  Value value;
  value.content_ = Dynamic{std::make_shared<const Value>(std::move(inner))};
  return value;
}

std::string Value::signature() const { return std::visit(SignatureOf{}, content_); }

const Value& Value::bare() const {
  const Value* value = this;
  while (const auto* dynamic = std::get_if<Dynamic>(&value->content_)) value = dynamic->inner.get();
  return *value;
}

bool Value::isVoid() const { return find<Void>() || find<Invalid>(); }

bool Value::isNumber() const { return findNumber() && !find<bool>(); }

bool Value::isString() const { return findText() != nullptr; }

bool Value::isList() const { return findItems() != nullptr; }

const std::vector<Value>* Value::findItems() const {
  if (const auto* list = find<List>()) return &list->items;
  if (const auto* tuple = find<Tuple>()) return &tuple->items;
  return nullptr;
}

std::optional<std::vector<Value>> Value::takeItems() && {
  if (auto* list = std::get_if<List>(&content_)) return std::move(list->items);
  if (auto* tuple = std::get_if<Tuple>(&content_)) return std::move(tuple->items);
  const auto* items = findItems();
  return items ? std::optional(*items) : std::nullopt;
}

std::optional<double> Value::findNumber() const {
  return std::visit(
      [](const auto& content) -> std::optional<double> {
        if constexpr (std::is_arithmetic_v<std::decay_t<decltype(content)>>) {
          return static_cast<double>(content);
        } else {
          return std::nullopt;
        }
      },
      bare().content_);
}

SharedBytes Value::findBytes() const {
  const auto* bytes = find<SharedBytes>();
  return bytes ? *bytes : nullptr;
}

std::string Value::print() const {
  std::ostringstream out;
  rpc::print(out, *this);
  return out.str();
}

}  // namespace nao::rpc
