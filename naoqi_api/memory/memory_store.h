#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "core/sim_time.h"
#include "naoqi_api/signal.h"
#include "naoqi_api/value.h"

namespace nao::memory {

/// What ALMemory.getType calls the storage class of a key. An event keeps a history, a micro-event
/// does not; otherwise they are alike.
enum class KeyType { Data, Event, MicroEvent };

/// A value and when it was written.
struct Stamped {
  rpc::Value value;  // void: declared, and never raised
  Duration time{};   // NaoQi's clock, since 1970
};

/// A key of the store as readers see it.
struct Entry {
  KeyType type = KeyType::Data;
  Stamped last;
  std::deque<Stamped> history;  // of an event, oldest first
  std::string description;
  std::string extractor;  // the module that raises the event, if it was declared with one
};

/// How much clients may store; all of these are free choices.
struct MemoryLimits {
  std::size_t keys = 65'536;
  std::size_t bytes = 64U << 20U;          // keys, values and histories, as sizeOf() counts
  std::size_t history_entries = 100;       // per event
  std::size_t history_bytes = 64U << 10U;  // per event; older values go first
};

/// What modules and clients of one robot know by name, and who waits for news of it. What the
/// devices measure is not in here (see DeviceKeys). One store per robot; I/O thread only. Listeners
/// are told inside the call that raises, in the order they came.
class MemoryStore {
 public:
  using Listener = std::function<void(const std::string& key, const rpc::Value& value)>;

  /// `clock` is NaoQi's: simulated time since 1970.
  explicit MemoryStore(std::function<Duration()> clock, MemoryLimits limits = {});

  /// Writes without telling anybody.
  void insert(const std::string& key, rpc::Value value);

  /// Makes the key an event, which has no value until it is raised.
  void declareEvent(const std::string& key, const std::string& extractor = {});

  /// Writes and tells the listeners of the key, whether or not the value changed.
  void raiseEvent(const std::string& key, const rpc::Value& value);
  void raiseMicroEvent(const std::string& key, const rpc::Value& value);

  /// Forgets the key; its listeners stay. False if there is none.
  bool remove(const std::string& key);

  /// Nobody hears of this key any more.
  void removeListeners(const std::string& key) { listeners_->erase(key); }

  /// False if there is no such key.
  bool describe(const std::string& key, std::string description);

  const Entry* find(const std::string& key) const;
  const std::map<std::string, Entry>& entries() const { return entries_; }

  /// Tells `listener` whenever the key is raised, until the returned token is gone. The key need
  /// not exist.
  [[nodiscard]] std::shared_ptr<void> listen(const std::string& key, Listener listener);
  /// The same for all that listens to `signal`, whose signature is "(m)".
  [[nodiscard]] std::shared_ptr<void> pass(const std::string& key, const rpc::Emitter& signal);
  std::size_t listenerCount(const std::string& key) const;

  /// For what comes from clients, before it is written. @throws CallError if there is no room for
  /// it, or it holds an object.
  void demandRoom(const std::string& key, const rpc::Value& value) const;

  Duration now() const { return clock_(); }
  std::size_t bytes() const { return bytes_; }

 private:
  using Listeners = std::map<std::string, rpc::Emitter>;
  class Token;

  std::shared_ptr<void> connect(const std::string& key, rpc::Emitter::Listener listener);

  /// A key about to be written, and the event to raise about that once it is: null if there is no
  /// news. Listeners come last, as they may change the store.
  struct Change {
    Entry& entry;
    const char* event;
  };

  Change change(const std::string& key, KeyType type);
  void write(Entry& entry, rpc::Value value);
  void keep(Entry& entry);
  void tell(const Change& change, const std::string& key) const;
  void tell(const std::string& key, const rpc::Value& value) const;
  static std::size_t sizeOfEntry(const std::string& key, const Entry& entry);

  std::function<Duration()> clock_;
  MemoryLimits limits_;
  std::map<std::string, Entry> entries_;
  std::size_t bytes_ = 0;
  std::shared_ptr<Listeners> listeners_ = std::make_shared<Listeners>();
};

}  // namespace nao::memory
