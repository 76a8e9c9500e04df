#include "naoqi_api/wire/metaobject.h"

#include <algorithm>
#include <string>
#include <vector>

#include "naoqi_api/wire/meta_signatures.h"

namespace nao::wire {
namespace {

using rpc::Argument;
using rpc::Method;
using rpc::Monitor;
using rpc::Service;
using rpc::Value;

constexpr BaseMethod kBaseMethods[] = {
    {base_action::kRegisterEvent, "registerEvent", "(IIL)", "L"},
    {base_action::kUnregisterEvent, "unregisterEvent", "(IIL)", "v"},
    {base_action::kMetaObject, "metaObject", "(I)", meta::kMetaObject},
    {base_action::kTerminate, "terminate", "(I)", "v"},
    {base_action::kProperty, "property", "(m)", "m"},
    {base_action::kSetProperty, "setProperty", "(mm)", "v"},
    {base_action::kProperties, "properties", "()", "[s]"},
    {base_action::kRegisterEventWithSignature, "registerEventWithSignature", "(IILs)", "L"},
    {base_action::kIsStatsEnabled, "isStatsEnabled", "()", "b"},
    {base_action::kEnableStats, "enableStats", "(b)", "v"},
    {base_action::kStats, "stats", "()", Monitor::kStatisticsSignature},
    {base_action::kClearStats, "clearStats", "()", "v"},
    {base_action::kIsTraceEnabled, "isTraceEnabled", "()", "b"},
    {base_action::kEnableTrace, "enableTrace", "(b)", "v"},
};

Value parametersOf(const Method& method, bool with_texts) {
  std::vector<Value> parameters;
  for (const Argument& argument : method.arguments) {
    if (!with_texts || argument.name.empty()) continue;
    parameters.push_back(Value::tuple(meta::kParameter, {argument.name, argument.meaning}));
  }
  return Value::listOf(meta::kParameter, std::move(parameters));
}

Value methodValue(const Method& method, bool with_texts) {
  const std::string none;
  return Value::tuple(
      meta::kMethod, {method.uid, method.return_signature, method.name, method.parameters_signature,
                      with_texts ? method.meaning : none, parametersOf(method, with_texts),
                      with_texts ? method.return_meaning : none});
}

Value baseMethodValue(const BaseMethod& base) {
  Method method;
  method.uid = base.uid;
  method.name = base.name;
  method.parameters_signature = base.parameters;
  method.return_signature = base.returns;
  return methodValue(method, false);
}

using Entries = std::vector<std::pair<Value, Value>>;

Entries methodsOf(const Service& service, bool with_texts) {
  Entries entries;
  for (const BaseMethod& base : kBaseMethods) entries.emplace_back(base.uid, baseMethodValue(base));
  for (const auto& [uid, method] : service.methods()) {
    entries.emplace_back(uid, methodValue(method, with_texts));
  }
  return entries;
}

void addSignal(Entries& entries, std::uint32_t uid, const std::string& name,
               const std::string& signature) {
  entries.emplace_back(uid, Value::tuple(meta::kSignal, {uid, name, signature}));
}

// A property is also a signal: it tells its changes.
Entries signalsOf(const Service& service) {
  Entries entries;
  addSignal(entries, base_action::kTraceObject, "traceObject", Monitor::kTraceSignature);
  for (const auto& [uid, signal] : service.signals()) {
    addSignal(entries, uid, signal.name, signal.emitter.signature());
  }
  for (const auto& [uid, property] : service.properties()) {
    addSignal(entries, uid, property.name, property.emitter.signature());
  }
  std::sort(entries.begin(), entries.end(), [](const auto& a, const auto& b) {
    return *a.first.findNumber() < *b.first.findNumber();
  });
  return entries;
}

Entries propertiesOf(const Service& service) {
  Entries entries;
  for (const auto& [uid, property] : service.properties()) {
    entries.emplace_back(uid,
                         Value::tuple(meta::kProperty, {uid, property.name, property.signature}));
  }
  return entries;
}

}  // namespace

const char* metaObjectSignature() { return meta::kMetaObject; }

const BaseMethod* findBaseMethod(std::uint32_t uid) {
  for (const BaseMethod& method : kBaseMethods) {
    if (method.uid == uid) return &method;
  }
  return nullptr;
}

const BaseTypes& typesOf(const BaseMethod& method) {
  static const auto all = [] {
    std::vector<BaseTypes> types;
    for (const BaseMethod& base : kBaseMethods) {
      types.push_back({Signature::of(base.parameters), Signature::of(base.returns)});
    }
    return types;
  }();
  return all[static_cast<std::size_t>(&method - kBaseMethods)];
}

Value metaObjectOf(const Service& service, bool with_texts) {
  return Value::tuple(meta::kMetaObject,
                      {Value::Map{"I", meta::kMethod, methodsOf(service, with_texts)},
                       Value::Map{"I", meta::kSignal, signalsOf(service)},
                       Value::Map{"I", meta::kProperty, propertiesOf(service)},
                       with_texts ? service.meaning() : std::string()});
}

}  // namespace nao::wire
