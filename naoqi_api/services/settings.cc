#include "naoqi_api/services/settings.h"

#include <algorithm>
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

// setX(x), and enableX(b) of the setting XEnabled, as far as they are documented.
std::vector<const DocumentedMethod*> settersOf(const DocumentedService& documented,
                                               const std::string& setting,
                                               const std::string& type) {
  static const std::string kEnabled = "Enabled";
  std::vector<std::string> names = {"set" + setting};
  const std::size_t stem = setting.size() - std::min(setting.size(), kEnabled.size());
  if (setting.substr(stem) == kEnabled) names.push_back("enable" + setting.substr(0, stem));
  std::vector<const DocumentedMethod*> setters;
  for (const std::string& name : names) {
    const DocumentedMethod* setter = find(documented, name, "(" + type + ")");
    if (setter != nullptr) setters.push_back(setter);
  }
  return setters;
}

rpc::Pending<Value> resolved(Value value) {
  rpc::Pending<Value> result;
  result.resolve(std::move(value));
  return result;
}

rpc::Method keeping(const DocumentedMethod& setter, const std::string& getter,
                    const std::shared_ptr<Value>& held) {
  rpc::Method keep;
  keep.name = setter.name;
  keep.parameters_signature = setter.parameters;
  keep.return_signature = setter.returns;
  keep.meaning = "Is kept, for " + getter + "() to tell.";
  keep.arguments = {{"value", "Its new value."}};
  const bool says_so = setter.returns == "b";
  keep.call = [held, says_so](const rpc::Caller&, const std::vector<Value>& arguments) {
    *held = arguments.at(0);
    return resolved(says_so ? Value(true) : Value());
  };
  return keep;
}

rpc::Method telling(const DocumentedMethod& getter, const std::string& setter,
                    const std::shared_ptr<Value>& held) {
  rpc::Method tell;
  tell.name = getter.name;
  tell.parameters_signature = getter.parameters;
  tell.return_signature = getter.returns;
  tell.meaning = "What " + setter + "() was told last.";
  tell.call = [held](const rpc::Caller&, const std::vector<Value>&) { return resolved(*held); };
  return tell;
}

void addSetting(rpc::Service& service, const DocumentedMethod& getter,
                const std::vector<const DocumentedMethod*>& setters, Value initial) {
  const auto held = std::make_shared<Value>(std::move(initial));
  service.add(telling(getter, setters.front()->name, held)).answering(rpc::Answer::Simplified);
  for (const DocumentedMethod* setter : setters) {
    if (has(service, setter->name, 1)) continue;
    service.add(keeping(*setter, getter.name, held)).answering(rpc::Answer::Simplified);
  }
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
    const auto setters = settersOf(documented, *setting, getter.returns);
    if (setters.empty() || has(service, setters.front()->name, 1)) continue;
    const auto initial = defaults.find(*setting);
    addSetting(service, getter, setters,
               initial == defaults.end() ? nothingOf(getter.returns) : initial->second);
  }
  if (find(documented, "setParameter", "(sm)")) addParameters(service, defaults);
}

}  // namespace nao::services
