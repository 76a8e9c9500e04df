#include "naoqi_api/fits.h"

#include <algorithm>
#include <string_view>

namespace nao::rpc {
namespace {

bool take(std::string_view& text, char wanted) {
  if (text.empty() || text.front() != wanted) return false;
  text.remove_prefix(1);
  return true;
}

// Whether `text` begins with the type's own text, which is taken off.
bool takeType(std::string_view& text, const Signature& type) {
  if (!take(text, type.kind())) return false;
  for (const Signature& child : type.children()) {
    if (!takeType(text, child)) return false;
  }
  if (type.is('[') && !take(text, ']')) return false;
  if (type.is('{') && !take(text, '}')) return false;
  if (type.is('(') && !take(text, ')')) return false;
  const std::string& annotation = type.annotation();
  if (annotation.empty()) return true;
  if (!take(text, '<') || text.substr(0, annotation.size()) != annotation) return false;
  text.remove_prefix(annotation.size());
  return take(text, '>');
}

bool isText(std::string_view text, const Signature& type) {
  return takeType(text, type) && text.empty();
}

bool allFit(const std::vector<Value>& items, const Signature& type) {
  return type.is('m') || std::all_of(items.begin(), items.end(),
                                     [&](const Value& item) { return fits(item, type); });
}

/// Looks at a value by its kind.
struct Fit {
  const Signature& type;

  bool is(char kind) const { return type.is(kind); }
  bool operator()(const Value::Void& /*none*/) const { return is('v') || is('_'); }
  bool operator()(const Value::Invalid& /*none*/) const { return false; }
  bool operator()(bool /*value*/) const { return is('b'); }
  bool operator()(std::int8_t /*value*/) const { return is('c'); }
  bool operator()(std::uint8_t /*value*/) const { return is('C'); }
  bool operator()(std::int16_t /*value*/) const { return is('w'); }
  bool operator()(std::uint16_t /*value*/) const { return is('W'); }
  bool operator()(std::int32_t /*value*/) const { return is('i'); }
  bool operator()(std::uint32_t /*value*/) const { return is('I'); }
  bool operator()(std::int64_t /*value*/) const { return is('l'); }
  bool operator()(std::uint64_t /*value*/) const { return is('L'); }
  bool operator()(float /*value*/) const { return is('f'); }
  bool operator()(double /*value*/) const { return is('d'); }
  bool operator()(const std::string& /*value*/) const { return is('s'); }
  bool operator()(const SharedBytes& bytes) const { return is('r') && bytes; }
  bool operator()(const Value::Dynamic& /*value*/) const { return false; }
  bool operator()(const ObjectRef& /*object*/) const { return is('o'); }
  bool operator()(const Value::List& list) const {
    if (!is('[')) return false;
    const Signature& element = type.children().front();
    return isText(list.element, element) && allFit(list.items, element);
  }
  bool operator()(const Value::Map& map) const {
    if (!is('{')) return false;
    const Signature& key = type.children()[0];
    const Signature& value = type.children()[1];
    if (!isText(map.key, key) || !isText(map.value, value)) return false;
    return std::all_of(map.entries.begin(), map.entries.end(), [&](const auto& entry) {
      return fits(entry.first, key) && fits(entry.second, value);
    });
  }
  bool operator()(const Value::Tuple& tuple) const {
    const auto& types = type.children();
    if (!is('(') || types.size() != tuple.items.size()) return false;
    if (!isText(tuple.signature, type)) return false;
    for (std::size_t i = 0; i < types.size(); ++i) {
      if (!fits(tuple.items[i], types[i])) return false;
    }
    return true;
  }
  bool operator()(const Value::Optional& optional) const {
    if (!is('+')) return false;
    const Signature& element = type.children().front();
    return isText(optional.element, element) && allFit(optional.item, element);
  }
};

}  // namespace

bool fits(const Value& value, const Signature& signature) {
  return signature.is('m') || std::visit(Fit{signature}, value.content());
}

}  // namespace nao::rpc
