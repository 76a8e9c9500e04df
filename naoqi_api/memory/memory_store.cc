#include "naoqi_api/memory/memory_store.h"

#include <utility>

#include "naoqi_api/call_error.h"
#include "naoqi_api/memory/value_size.h"

namespace nao::memory {
namespace {

using rpc::Value;

// ALMemory's own events (NAOqi 2.1.4.13 documentation, almemory-api.html).
constexpr char kKeyAdded[] = "ALMemory/KeyAdded";
constexpr char kKeyRemoved[] = "ALMemory/KeyRemoved";
constexpr char kKeyTypeChanged[] = "ALMemory/KeyTypeChanged";

constexpr std::size_t kEntryBytes = sizeof(Entry) + 64;  // and what a node of the map costs

}  // namespace

// One listener. It holds the emitter, not the store: either may go first.
class MemoryStore::Token {
 public:
  Token(std::weak_ptr<Listeners> listeners, std::string key, rpc::Emitter emitter,
        std::uint64_t link)
      : listeners_(std::move(listeners)),
        key_(std::move(key)),
        emitter_(std::move(emitter)),
        link_(link) {}
  Token(const Token&) = delete;
  Token& operator=(const Token&) = delete;
  ~Token() {
    emitter_.disconnect(link_);
    const auto listeners = listeners_.lock();
    if (!listeners) return;
    const auto found = listeners->find(key_);
    if (found != listeners->end() && found->second.listenerCount() == 0) listeners->erase(found);
  }

 private:
  std::weak_ptr<Listeners> listeners_;
  std::string key_;
  rpc::Emitter emitter_;
  std::uint64_t link_;
};

MemoryStore::MemoryStore(std::function<Duration()> clock, MemoryLimits limits)
    : clock_(std::move(clock)), limits_(limits) {}

MemoryStore::Change MemoryStore::change(const std::string& key, KeyType type) {
  const auto [found, added] = entries_.try_emplace(key);
  Entry& entry = found->second;
  if (added) {
    entry.type = type;
    entry.last.time = now();
    bytes_ += sizeOfEntry(key, entry);
    return {entry, kKeyAdded};
  }
  if (entry.type != KeyType::Data || type == KeyType::Data) return {entry, nullptr};
  entry.type = type;
  return {entry, kKeyTypeChanged};
}

void MemoryStore::write(Entry& entry, Value value) {
  bytes_ -= sizeOf(entry.last.value);
  bytes_ += sizeOf(value);
  entry.last = {std::move(value), now()};
}

// Adds the last value to the history, and drops what is too old.
void MemoryStore::keep(Entry& entry) {
  entry.history.push_back(entry.last);
  std::size_t size = 0;
  for (const Stamped& past : entry.history) size += sizeOf(past.value);
  bytes_ += sizeOf(entry.last.value);
  while (!entry.history.empty() &&
         (entry.history.size() > limits_.history_entries || size > limits_.history_bytes)) {
    const std::size_t oldest = sizeOf(entry.history.front().value);
    size -= oldest;
    bytes_ -= oldest;
    entry.history.pop_front();
  }
}

void MemoryStore::insert(const std::string& key, Value value) {
  const Change change = this->change(key, KeyType::Data);
  write(change.entry, std::move(value));
  tell(change, key);
}

void MemoryStore::declareEvent(const std::string& key, const std::string& extractor) {
  const Change change = this->change(key, KeyType::Event);
  bytes_ += extractor.size();
  bytes_ -= change.entry.extractor.size();
  change.entry.extractor = extractor;
  tell(change, key);
}

void MemoryStore::raiseEvent(const std::string& key, const Value& value) {
  const Change change = this->change(key, KeyType::Event);
  write(change.entry, value);
  if (change.entry.type == KeyType::Event) keep(change.entry);
  tell(change, key);
  tell(key, value);
}

void MemoryStore::raiseMicroEvent(const std::string& key, const Value& value) {
  const Change change = this->change(key, KeyType::MicroEvent);
  write(change.entry, value);
  tell(change, key);
  tell(key, value);
}

bool MemoryStore::remove(const std::string& key) {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return false;
  bytes_ -= sizeOfEntry(key, found->second);
  entries_.erase(found);
  tell(kKeyRemoved, Value(key));
  return true;
}

bool MemoryStore::describe(const std::string& key, std::string description) {
  const auto found = entries_.find(key);
  if (found == entries_.end()) return false;
  bytes_ += description.size();
  bytes_ -= found->second.description.size();
  found->second.description = std::move(description);
  return true;
}

const Entry* MemoryStore::find(const std::string& key) const {
  const auto found = entries_.find(key);
  return found == entries_.end() ? nullptr : &found->second;
}

std::shared_ptr<void> MemoryStore::listen(const std::string& key, Listener listener) {
  return connect(key, [key, listener = std::move(listener)](const std::vector<Value>& arguments) {
    listener(key, arguments.front());
  });
}

std::shared_ptr<void> MemoryStore::pass(const std::string& key, const rpc::Emitter& signal) {
  return connect(key, [signal](const rpc::Emission& emission) { signal.pass(emission); });
}

std::shared_ptr<void> MemoryStore::connect(const std::string& key,
                                           rpc::Emitter::Listener listener) {
  const rpc::Emitter emitter = listeners_->try_emplace(key, "(m)").first->second;
  const std::uint64_t link = emitter.connect(std::move(listener));
  return std::make_shared<Token>(listeners_, key, emitter, link);
}

std::size_t MemoryStore::listenerCount(const std::string& key) const {
  const auto found = listeners_->find(key);
  return found == listeners_->end() ? 0 : found->second.listenerCount();
}

void MemoryStore::tell(const Change& change, const std::string& key) const {
  if (change.event) tell(change.event, Value(key));
}

void MemoryStore::tell(const std::string& key, const Value& value) const {
  const auto found = listeners_->find(key);
  if (found == listeners_->end()) return;
  const rpc::Emitter emitter = found->second;  // a listener may remove the key
  emitter.emit({value});
}

void MemoryStore::demandRoom(const std::string& key, const Value& value) const {
  if (holdsObject(value)) throw rpc::CallError("an object can not be kept in memory");
  const Entry* known = find(key);
  if (!known && entries_.size() >= limits_.keys) {
    throw rpc::CallError("no room for another key: there are " + std::to_string(limits_.keys) +
                         " already");
  }
  // Twice: the value, and its copy in an event's history.
  std::size_t needed = 2 * sizeOf(value);
  if (!known) needed += sizeOfEntry(key, {});
  const std::size_t freed = known ? sizeOf(known->last.value) : 0;
  if (bytes_ + needed > limits_.bytes + freed) {
    throw rpc::CallError("no room for the value of " + key + ": memory holds at most " +
                         std::to_string(limits_.bytes >> 20U) + " MiB");
  }
}

std::size_t MemoryStore::sizeOfEntry(const std::string& key, const Entry& entry) {
  std::size_t size = kEntryBytes + key.size() + entry.description.size() + entry.extractor.size() +
                     sizeOf(entry.last.value);
  for (const Stamped& past : entry.history) size += sizeOf(past.value);
  return size;
}

}  // namespace nao::memory
