#include "naoqi_api/services/al_preferences.h"

#include <map>
#include <string>
#include <utility>

#include "naoqi_api/al_module.h"
#include "naoqi_api/memory/value_size.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

constexpr std::size_t kMostBytes = 16U << 20U;  // of all values; free

/// Values by domain and key.
class Preferences {
 public:
  using Domain = std::map<std::string, Value>;

  void set(const std::string& domain, const std::string& key, const Value& value) {
    if (memory::holdsObject(value)) throw CallError("an object can not be kept");
    const std::size_t size = domain.size() + key.size() + memory::sizeOf(value);
    if (bytes_ + size > kMostBytes) throw CallError("there is no more room for preferences");
    bytes_ += size;  // what is replaced still counts: a limit, not an account
    domains_[domain][key] = value;
  }
  const Domain* find(const std::string& domain) const {
    const auto found = domains_.find(domain);
    return found == domains_.end() ? nullptr : &found->second;
  }
  void removeValue(const std::string& domain, const std::string& key) {
    const auto found = domains_.find(domain);
    if (found == domains_.end() || found->second.erase(key) == 0) {
      throw CallError("there is no preference " + key + " of " + domain);
    }
  }
  void removeDomain(const std::string& domain) { domains_.erase(domain); }
  const std::map<std::string, Domain>& domains() const { return domains_; }

 private:
  std::map<std::string, Domain> domains_;
  std::size_t bytes_ = 0;
};

std::shared_ptr<rpc::Service> makeManager(const ServiceContext& context) {
  auto service = std::make_shared<rpc::Service>(rpc::alModule(
      "ALPreferenceManager", "Values by domain and key, kept until the daemon ends."));
  context.store().declareEvent("preferenceChanged", "ALPreferenceManager");
  const auto held = std::make_shared<Preferences>();
  const Argument domain{"domain", "Such as com.example.app."};
  const Argument key{"setting", "Its name."};
  addFunction(
      *service, "setValue",
      [held, &store = context.store()](const std::string& of, const std::string& name,
                                       const Value& value) {
        held->set(of, name, value);
        store.raiseEvent("preferenceChanged", Value::list({of, name, value}));
      },
      "Keeps a value.", domain, key, Argument{"value", "Anything but an object."});
  addFunction(
      *service, "getValue",
      [held](const std::string& of, const std::string& name) -> Value {
        const auto* values = held->find(of);
        if (!values || values->count(name) == 0) return {};
        return values->at(name);
      },
      "A value; nothing if there is none.", domain, key);
  addFunction(
      *service, "getValueList",
      [held](const std::string& of) {
        std::vector<std::vector<Value>> list;
        if (const auto* values = held->find(of)) {
          for (const auto& [name, value] : *values) list.push_back({name, value});
        }
        return list;
      },
      "[[setting, value], ...] of a domain.", domain);
  addFunction(
      *service, "removeValue",
      [held](const std::string& of, const std::string& name) { held->removeValue(of, name); },
      "Forgets a value.", domain, key);
  addFunction(
      *service, "removeDomainValues", [held](const std::string& of) { held->removeDomain(of); },
      "Forgets a domain.", domain);
  addFunction(
      *service, "getDomainList",
      [held] {
        std::vector<std::string> names;
        for (const auto& [name, values] : held->domains()) names.push_back(name);
        return names;
      },
      "The domains.");
  addFunction(
      *service, "update", [] {}, "Has no effect: nothing is kept elsewhere.")
      .answering(rpc::Answer::Simplified);
  return service;
}

// A file of preferences is [name, description, "", [[...], ...]]; its shape is the client's.
std::shared_ptr<rpc::Service> makeFiles() {
  auto service = std::make_shared<rpc::Service>(
      rpc::alModule("ALPreferences", "Preferences by file name, kept until the daemon ends."));
  const auto held = std::make_shared<Preferences>();
  const Argument name{"fileName", "Its name, no path."};
  const Argument save{"autoSave", "Has no effect."};
  addFunction(
      *service, "readPrefFile",
      [held](const std::string& file, bool) {
        const auto* values = held->find(file);
        return values ? values->at("") : Value::list({});
      },
      "What was written under this name; an empty list if nothing was.", name, save);
  addFunction(
      *service, "writePrefFile",
      [held](const std::string& file, const Value& value, bool) { held->set(file, "", value); },
      "Keeps preferences.", name, Argument{"prefs", "A list."}, save);
  addFunction(
      *service, "removePrefFile", [held](const std::string& file) { held->removeDomain(file); },
      "Forgets preferences.", name);
  addFunction(
      *service, "saveToMemory", [](const Value&) { return true; },
      "True; nothing is written to ALMemory.", Argument{"prefs", "Ignored."});
  service->allAnswering(rpc::Answer::Simplified);
  return service;
}

}  // namespace

std::vector<std::shared_ptr<rpc::Service>> makePreferences(const ServiceContext& context) {
  return {makeManager(context), makeFiles()};
}

}  // namespace nao::services
