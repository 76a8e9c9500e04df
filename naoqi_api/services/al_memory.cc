#include "naoqi_api/services/al_memory.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <utility>

#include "naoqi_api/call_error.h"

namespace nao::services {
namespace {

using memory::KeyType;
using memory::Stamped;
using rpc::CallError;
using rpc::Value;

const char* nameOf(KeyType type) {
  switch (type) {
    case KeyType::Data:
      return "Data";
    case KeyType::Event:
      return "Event";
    case KeyType::MicroEvent:
      return "MicroEvent";
  }
  return "";
}

// Seconds and microseconds, as two ints.
std::pair<Value, Value> split(Duration time) {
  using std::chrono::microseconds;
  using std::chrono::seconds;
  const auto whole = std::chrono::duration_cast<seconds>(time);
  const auto rest = std::chrono::duration_cast<microseconds>(time - whole);
  return {static_cast<std::int32_t>(whole.count()), static_cast<std::int32_t>(rest.count())};
}

[[noreturn]] void throwNotFound(const std::string& key) {
  throw CallError("Data not found " + key);
}

}  // namespace

AlMemory::AlMemory(memory::RobotMemory& memory, FindModule find_module)
    : memory_(memory), callbacks_(memory.store(), std::move(find_module)) {}

Stamped AlMemory::read(const std::string& key) const {
  auto found = memory_.read(key);
  if (!found) throwNotFound(key);
  return *std::move(found);
}

Value AlMemory::getData(const std::string& key) { return read(key).value; }

Value AlMemory::getDataOld(const std::string& key, std::int32_t /*unused*/) { return getData(key); }

rpc::Pending<Value> AlMemory::getDataOnChange(const std::string& key, std::int32_t /*unused*/) {
  constexpr std::size_t kMost = 1024;
  if (awaited_.size() >= kMost) throw CallError("too many calls wait for a key to change");
  Awaited awaited{key, read(key).value, {}};
  awaited.pending.onlyWaits();
  awaited_.push_back(awaited);
  return awaited.pending;
}

void AlMemory::deliver() {
  std::vector<Awaited> before;
  before.swap(awaited_);
  for (Awaited& awaited : before) {
    if (awaited.pending.isDone()) continue;  // canceled
    const auto found = memory_.read(awaited.key);
    if (!found) {
      awaited.pending.fail("Data not found " + awaited.key);
    } else if (found->value != awaited.before) {
      awaited.pending.resolve(found->value);
    } else {
      awaited_.push_back(std::move(awaited));
    }
  }
}

Value AlMemory::getDataPtr(const std::string& /*key*/) {
  throw CallError("ALMemory::getDataPtr Cannot be called remotely");
}

// A key that is not there gives an empty value in its place: how NaoQi does it is not documented.
Value AlMemory::getListData(const rpc::OneOrMany<std::string>& keys) {
  const auto frames = memory_.devices().frames();
  std::vector<Value> values;
  values.reserve(keys.size());
  for (const std::string& key : keys) {
    auto found = memory_.read(key, frames);
    values.push_back(found ? std::move(found->value) : Value());
  }
  return Value::list(std::move(values));
}

Value AlMemory::getTimestamp(const std::string& key) {
  Stamped found = read(key);
  const auto [seconds, microseconds] = split(found.time);
  return Value::list({std::move(found.value), seconds, microseconds});
}

Value AlMemory::getEventHistory(const std::string& key) {
  if (!memory_.typeOf(key)) throwNotFound(key);
  std::vector<Value> history;
  if (const memory::Entry* entry = memory_.store().find(key)) {
    for (const Stamped& past : entry->history) {
      const auto [seconds, microseconds] = split(past.time);
      history.push_back(Value::list({past.value, Value::list({seconds, microseconds})}));
    }
  }
  return Value::list(std::move(history));
}

std::vector<std::string> AlMemory::getExtractorEvent(const std::string& extractor) {
  std::vector<std::string> events;
  for (const auto& [key, entry] : memory_.store().entries()) {
    if (!extractor.empty() && entry.extractor == extractor) events.push_back(key);
  }
  return events;
}

std::string AlMemory::getType(const std::string& key) {
  const auto type = memory_.typeOf(key);
  if (!type) throwNotFound(key);
  return nameOf(*type);
}

// [[key, "data" or "event", description], ...] of these keys, or of all that have one.
Value AlMemory::getDescriptionList(const std::vector<std::string>& keys) {
  const auto& entries = memory_.store().entries();
  std::vector<std::string> wanted = keys;
  for (const auto& [key, entry] : entries) {
    if (keys.empty() && !entry.description.empty()) wanted.push_back(key);
  }
  std::vector<Value> list;
  for (const std::string& key : wanted) {
    const auto type = memory_.typeOf(key);
    if (!type) throwNotFound(key);
    const auto entry = entries.find(key);
    list.push_back(Value::list({key, *type == KeyType::Data ? "data" : "event",
                                entry == entries.end() ? "" : entry->second.description}));
  }
  return Value::list(std::move(list));
}

void AlMemory::insertData(const std::string& key, const Value& value) {
  memory_.store().demandRoom(key, value);
  memory_.store().insert(key, value);
}

void AlMemory::insertListData(const Value& list) {
  const std::vector<Value>* pairs = list.findItems();
  if (!pairs) throw CallError("expected [[key, value], ...], got " + list.print());
  for (const Value& pair : *pairs) {
    const std::vector<Value>* items = pair.findItems();
    if (!items || items->size() != 2 || !items->front().findText()) {
      throw CallError("expected [key, value], got " + pair.print());
    }
  }
  for (const Value& pair : *pairs) {
    const std::vector<Value>& items = *pair.findItems();
    insertData(*items[0].findText(), items[1].bare());
  }
}

void AlMemory::setDescription(const std::string& key, const std::string& description) {
  memory_.store().demandRoom(key, description);
  if (!memory_.store().describe(key, description)) throwNotFound(key);
}

void AlMemory::declareExtractorEvent(const std::string& key, const std::string& extractor) {
  memory_.store().demandRoom(key, extractor);
  memory_.store().declareEvent(key, extractor);
}

void AlMemory::raiseEvent(const std::string& key, const Value& value) {
  memory_.store().demandRoom(key, value);
  memory_.store().raiseEvent(key, value);
}

void AlMemory::raiseMicroEvent(const std::string& key, const Value& value) {
  memory_.store().demandRoom(key, value);
  memory_.store().raiseMicroEvent(key, value);
}

void AlMemory::removeEvent(const std::string& key) {
  for (const std::string& module : callbacks_.modulesOf(key)) callbacks_.remove(key, module);
  memory_.store().removeListeners(key);
  memory_.store().remove(key);
  subscribers_.erase(key);
}

// One for all clients: an event is passed on once, however many listen.
std::shared_ptr<rpc::Service> AlMemory::subscriber(const std::string& event) {
  if (auto known = subscribers_[event].lock()) return known;
  const rpc::Signal<Value> signal;
  auto token = memory_.store().pass(event, signal.emitter());
  auto object = std::make_shared<rpc::Service>("subscriber", "Tells of " + event + ".");
  object->signal("signal", signal).owning(std::move(token));
  forgetSubscribers();
  subscribers_[event] = object;
  return object;
}

// Those of events that nobody listens to any more, now and then.
void AlMemory::forgetSubscribers() {
  if (subscribers_.size() < forget_at_) return;
  for (auto it = subscribers_.begin(); it != subscribers_.end();) {
    it = it->second.expired() ? subscribers_.erase(it) : std::next(it);
  }
  forget_at_ = std::max(kForgetAt, 2 * subscribers_.size());
}

void AlMemory::subscribeToEvent(const rpc::Caller& caller, const std::string& event,
                                const std::string& module, const std::string& method) {
  callbacks_.add(event, {module, method, ""}, caller.session);
}

void AlMemory::subscribeWithMessage(const rpc::Caller& caller, const std::string& event,
                                    const std::string& module, const std::string& message,
                                    const std::string& method) {
  callbacks_.add(event, {module, method, message}, caller.session);
}

void AlMemory::unsubscribeToEvent(const std::string& event, const std::string& module) {
  if (!callbacks_.remove(event, module)) {
    throw CallError("module " + module + " has not subscribed to " + event);
  }
}

void AlMemory::unregisterModuleReference(const std::string& module) {
  callbacks_.removeModule(module);
}

std::vector<std::string> AlMemory::getSubscribers(const std::string& event) {
  return callbacks_.modulesOf(event);
}

void AlMemory::addMapping(const std::string& service, const std::string& signal,
                          const std::string& event) {
  constexpr int kMost = 1024;
  if (mappings_ >= kMost) throw CallError("too many signals are mapped");
  const auto found = find_service_ ? find_service_(service) : nullptr;
  if (!found) throw CallError("the robot has no service " + service);
  for (const auto& [uid, member] : found->signals()) {
    if (member.name != signal) continue;
    memory_.store().declareEvent(event);
    ++mappings_;
    member.emitter.connect([this, event](const std::vector<Value>& values) {
      memory_.store().raiseEvent(event, values.size() == 1 ? values.front() : Value::list(values));
    });
    return;
  }
  throw CallError(service + " has no signal " + signal);
}

void AlMemory::addMappings(const std::string& service,
                           const std::map<std::string, std::string>& events) {
  for (const auto& [signal, event] : events) addMapping(service, signal, event);
}

}  // namespace nao::services
