#include "naoqi_api/services/al_preferences.h"

#include <string>
#include <utility>

#include "naoqi_api/al_module.h"
#include "naoqi_api/services/naoqi_method.h"
#include "naoqi_api/services/preferences.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::CallError;
using rpc::Value;

constexpr int kDeepest = 16;  // preferences within preferences

// [name, description, value, [[...], ...] of those below it] as keys "name" and "name/name".
void insertAll(memory::MemoryStore& store, const std::string& folder, const Value& preference,
               int depth) {
  const auto* parts = preference.findItems();
  if (!parts || parts->size() < 3 || !parts->front().findText() || depth > kDeepest) {
    throw CallError("expected [name, description, value, list], got " + preference.print());
  }
  const std::string key = folder + *parts->front().findText();
  const auto* below = parts->size() > 3 ? (*parts)[3].findItems() : nullptr;
  if (!below || below->empty()) {
    store.demandRoom(key, (*parts)[2]);
    return store.insert(key, (*parts)[2]);
  }
  for (const Value& one : *below) insertAll(store, key + "/", one, depth + 1);
}

std::shared_ptr<rpc::Service> makeManager(const ServiceContext& context) {
  auto service = std::make_shared<rpc::Service>(rpc::alModule(
      "ALPreferenceManager", "Values by domain and key, kept below --data-dir if there is one."));
  context.store().declareEvent("preferenceChanged", "ALPreferenceManager");
  const auto held =
      std::make_shared<Preferences>(context, "preferences/" + context.robot_name + ".jsonl");
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
      [held](const std::string& of, const std::string& name) { held->remove(of, name); },
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
std::shared_ptr<rpc::Service> makeFiles(const ServiceContext& context) {
  auto service = std::make_shared<rpc::Service>(rpc::alModule(
      "ALPreferences", "Preferences by file name, kept below --data-dir if there is one."));
  const auto held =
      std::make_shared<Preferences>(context, "preferences/" + context.robot_name + ".files.jsonl");
  const Argument name{"fileName", "Its name, no path."};
  const Argument save{"autoSave", "Changes nothing: what is written is kept."};
  addFunction(
      *service, "readPrefFile",
      [held](const std::string& file, bool) {
        const auto* values = held->find(file);
        const auto value = values ? values->find("") : Preferences::Domain::const_iterator();
        return values && value != values->end() ? value->second : Value::list({});
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
      *service, "saveToMemory",
      [&store = context.store()](const Value& preferences) {
        insertAll(store, "", preferences, 0);
        return true;
      },
      "Writes preferences to ALMemory, under \"name\" or \"name/name\".",
      Argument{"prefs", "[name, description, value, list of those below it]."});
  return service;
}

}  // namespace

std::vector<std::shared_ptr<rpc::Service>> makePreferences(const ServiceContext& context) {
  return {makeManager(context), makeFiles(context)};
}

}  // namespace nao::services
