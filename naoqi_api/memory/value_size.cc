#include "naoqi_api/memory/value_size.h"

#include <algorithm>

namespace nao::memory {
namespace {

using rpc::Value;

// Calls `visit` with each value directly inside `value`.
template <class F>
void forEachInside(const Value& value, const F& visit) {
  if (const auto* dynamic = std::get_if<Value::Dynamic>(&value.content())) {
    if (dynamic->inner) visit(*dynamic->inner);
  } else if (const auto* map = std::get_if<Value::Map>(&value.content())) {
    for (const auto& [key, mapped] : map->entries) {
      visit(key);
      visit(mapped);
    }
  } else if (const auto* optional = std::get_if<Value::Optional>(&value.content())) {
    for (const Value& item : optional->item) visit(item);
  } else if (const std::vector<Value>* items = value.findItems()) {
    for (const Value& item : *items) visit(item);
  }
}

// Of the types that a value keeps beside its items: a client may make them long.
std::size_t typeLetters(const Value& value) {
  const auto& content = value.content();
  if (const auto* list = std::get_if<Value::List>(&content)) return list->element.size();
  if (const auto* tuple = std::get_if<Value::Tuple>(&content)) return tuple->signature.size();
  if (const auto* optional = std::get_if<Value::Optional>(&content)) {
    return optional->element.size();
  }
  const auto* map = std::get_if<Value::Map>(&content);
  return map ? map->key.size() + map->value.size() : 0;
}

}  // namespace

std::size_t sizeOf(const Value& value) {
  std::size_t size = sizeof(Value);
  if (const auto* text = std::get_if<std::string>(&value.content())) size += text->size();
  if (const auto* bytes = std::get_if<rpc::SharedBytes>(&value.content())) {
    if (*bytes) size += (*bytes)->size();
  }
  size += typeLetters(value);
  forEachInside(value, [&](const Value& inside) { size += sizeOf(inside); });
  return size;
}

bool holdsObject(const Value& value) {
  bool found = std::holds_alternative<rpc::ObjectRef>(value.content());
  forEachInside(value, [&](const Value& inside) { found = found || holdsObject(inside); });
  return found;
}

}  // namespace nao::memory
