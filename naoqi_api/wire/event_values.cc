#include "naoqi_api/wire/event_values.h"

#include <utility>

#include "naoqi_api/convert.h"

namespace nao::wire {

using rpc::Bend;
using rpc::Signature;
using rpc::Value;

namespace {

Bend bendTo(const Signature& declared) {
  return declared.is('[') ? Bend::Loose : Bend::Declared;  // a tuple of arguments to their list
}

bool fitOneByOne(const std::vector<Value>& arguments, const Signature& declared) {
  const auto& types = declared.children();
  if (!declared.is('(') || arguments.size() != types.size()) return false;
  for (std::size_t i = 0; i < types.size(); ++i) {
    if (!rpc::fits(arguments[i], types[i])) return false;
  }
  return true;
}

// Those that together are a type, so that they can be told on: one may be nested too deep for that.
std::optional<std::vector<Value>> argumentsIn(Value dynamic) {
  std::vector<Value> arguments;
  if (dynamic.find<Value::Tuple>()) {
    arguments = *std::move(dynamic).takeItems();
  } else {
    arguments.push_back(std::move(dynamic));
  }
  if (!Signature::parse(Value::tuple(arguments).signature())) return std::nullopt;
  return arguments;
}

}  // namespace

bool carriesArguments(const Signature& type) {
  return type.is('(') || type.is('[') || type.is('m');
}

bool encodeEvent(rpc::Bytes& out, const std::vector<Value>& arguments, const Signature& declared,
                 ObjectCodec* objects) {
  if (fitOneByOne(arguments, declared)) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      encode(out, arguments[i], declared.children()[i], objects);
    }
    return true;
  }
  const auto event = rpc::convert(Value::tuple(arguments), declared, bendTo(declared));
  if (event) encode(out, *event, declared, objects);
  return event.has_value();
}

std::optional<std::vector<Value>> argumentsOf(Value event, const Signature& declared) {
  if (declared.is('m')) return argumentsIn(std::move(event));
  auto fitting = rpc::convert(event, declared, bendTo(declared));
  if (!fitting) return std::nullopt;
  return *std::move(*fitting).takeItems();
}

}  // namespace nao::wire
