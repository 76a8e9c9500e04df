#include "naoqi_api/services/settings.h"

#include <memory>
#include <optional>
#include <utility>

#include "naoqi_api/convert.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Value;

constexpr std::size_t kMostParameters = 256;

Value nothingOf(const std::string& signature) {
  if (signature == "b") return false;
  if (signature == "i" || signature == "I") return 0;
  if (signature == "f") return 0.0F;
  if (signature == "s") return "";
  if (signature == "m") return Value::list({});
  if (signature[0] == '[') return Value::listOf(signature.substr(1, signature.size() - 2), {});
  return {};
}

const DocumentedMethod* find(const DocumentedService& documented, const std::string& name,
                             const std::string& parameters) {
  for (const DocumentedMethod& method : documented.methods) {
    if (method.name == name && method.parameters == parameters) return &method;
  }
  return nullptr;
}

bool has(const rpc::Service& service, const std::string& name, std::size_t arguments) {
  return service.findMethod(name, std::vector<Value>(arguments, Value(0))) != nullptr;
}

// "getX" and "isX" are of the setting X.
std::optional<std::string> settingOf(const std::string& getter) {
  if (getter.rfind("get", 0) == 0) return getter.substr(3);
  if (getter.rfind("is", 0) == 0) return getter.substr(2);
  return std::nullopt;
}

rpc::Pending<Value> resolved(Value value) {
  rpc::Pending<Value> result;
  result.resolve(std::move(value));
  return result;
}

void addPair(rpc::Service& service, const DocumentedMethod& getter, const DocumentedMethod& setter,
             Value initial) {
  const auto held = std::make_shared<Value>(std::move(initial));
  rpc::Method tell;
  tell.name = getter.name;
  tell.parameters_signature = getter.parameters;
  tell.return_signature = getter.returns;
  tell.meaning = "What " + setter.name + "() was told last.";
  tell.call = [held](const rpc::Caller&, const std::vector<Value>&) { return resolved(*held); };
  rpc::Method keep;
  keep.name = setter.name;
  keep.parameters_signature = setter.parameters;
  keep.return_signature = setter.returns;
  keep.meaning = "Is kept, for " + getter.name + "() to tell.";
  keep.arguments = {{"value", "Its new value."}};
  const bool says_so = setter.returns == "b";
  keep.call = [held, says_so](const rpc::Caller&, const std::vector<Value>& arguments) {
    *held = arguments.at(0);
    return resolved(says_so ? Value(true) : Value());
  };
  service.add(std::move(tell)).answering(rpc::Answer::Simplified);
  service.add(std::move(keep)).answering(rpc::Answer::Simplified);
}

void addParameters(rpc::Service& service, const SettingDefaults& defaults) {
  const auto held = std::make_shared<SettingDefaults>(defaults);
  if (!has(service, "setParameter", 2)) {
    addFunction(
        service, "setParameter",
        [held](const std::string& name, const Value& value) {
          if (held->size() >= kMostParameters && held->count(name) == 0) {
            throw rpc::CallError("too many parameters");
          }
          (*held)[name] = value;
        },
        "Is kept, for getParameter() to tell.", rpc::Argument{"name", "Its name."},
        rpc::Argument{"value", "Its new value."})
        .answering(rpc::Answer::Simplified);
  }
  if (has(service, "getParameter", 1)) return;
  addFunction(
      service, "getParameter",
      [held](const std::string& name) {
        const auto found = held->find(name);
        if (found == held->end()) throw rpc::CallError("there is no parameter " + name);
        return found->second;
      },
      "What setParameter() was told last.", rpc::Argument{"name", "Its name."})
      .answering(rpc::Answer::Simplified);
}

}  // namespace

void addSettings(rpc::Service& service, const DocumentedService& documented,
                 const SettingDefaults& defaults) {
  for (const DocumentedMethod& getter : documented.methods) {
    const auto setting = settingOf(getter.name);
    if (!setting || getter.parameters != "()" || has(service, getter.name, 0)) continue;
    const auto* setter = find(documented, "set" + *setting, "(" + getter.returns + ")");
    if (!setter || has(service, setter->name, 1)) continue;
    const auto initial = defaults.find(*setting);
    addPair(service, getter, *setter,
            initial == defaults.end() ? nothingOf(getter.returns) : initial->second);
  }
  if (find(documented, "setParameter", "(sm)")) addParameters(service, defaults);
}

}  // namespace nao::services
