#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "naoqi_api/memory/robot_memory.h"
#include "naoqi_api/remote_object.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/al_memory_callbacks.h"

namespace nao::services {

/// NaoQi's ALMemory: reads and writes the robot's memory, and tells clients of events, either
/// through a subscriber object or by calling a method of a module that the client hosts. What a
/// client subscribed goes with the client. I/O thread.
class AlMemory {
 public:
  /// `memory` outlives it. `find_module` may be empty: then no module can be called back.
  explicit AlMemory(memory::RobotMemory& memory, FindModule find_module = {});

  /// Finds services of the robot whose signals may be mapped to events; null if there is none.
  using FindService = std::function<std::shared_ptr<rpc::Service>(const std::string& name)>;
  void setFindService(FindService find_service) { find_service_ = std::move(find_service); }

  /// After each cycle of the robot: tells those who wait for a key to change.
  void deliver();

  /// The service; this object must outlive it.
  rpc::Service describe();

 private:
  // Reading
  rpc::Value getData(const std::string& key);
  rpc::Value getDataOld(const std::string& key, std::int32_t unused);
  rpc::Pending<rpc::Value> getDataOnChange(const std::string& key, std::int32_t unused);
  rpc::Value getDataPtr(const std::string& key);
  rpc::Value getListData(const rpc::OneOrMany<std::string>& keys);
  rpc::Value getTimestamp(const std::string& key);
  rpc::Value getEventHistory(const std::string& key);
  std::vector<std::string> getDataList(const std::string& filter) { return memory_.names(filter); }
  std::vector<std::string> getDataListName() { return memory_.names(); }
  std::vector<std::string> getEventList() { return memory_.namesOf(memory::KeyType::Event); }
  std::vector<std::string> getMicroEventList() {
    return memory_.namesOf(memory::KeyType::MicroEvent);
  }
  std::vector<std::string> getExtractorEvent(const std::string& extractor);
  std::string getType(const std::string& key);
  rpc::Value getDescriptionList(const std::vector<std::string>& keys);

  // Writing
  void insertInt(const std::string& key, std::int32_t value) { insertData(key, value); }
  void insertFloat(const std::string& key, float value) { insertData(key, value); }
  void insertText(const std::string& key, const std::string& value) { insertData(key, value); }
  void insertData(const std::string& key, const rpc::Value& value);
  void insertListData(const rpc::Value& list);
  void removeData(const std::string& key) { memory_.store().remove(key); }
  void setDescription(const std::string& key, const std::string& description);

  // Events
  void declareEvent(const std::string& key) { declareExtractorEvent(key, {}); }
  void declareExtractorEvent(const std::string& key, const std::string& extractor);
  void raiseEvent(const std::string& key, const rpc::Value& value);
  void raiseMicroEvent(const std::string& key, const rpc::Value& value);
  void removeEvent(const std::string& key);

  // Being told of them
  std::shared_ptr<rpc::Service> subscriber(const std::string& event);
  void subscribeToEvent(const rpc::Caller& caller, const std::string& event,
                        const std::string& module, const std::string& method);
  void subscribeWithMessage(const rpc::Caller& caller, const std::string& event,
                            const std::string& module, const std::string& message,
                            const std::string& method);
  void unsubscribeToEvent(const std::string& event, const std::string& module);
  void unregisterModuleReference(const std::string& module);
  std::vector<std::string> getSubscribers(const std::string& event);
  void addMapping(const std::string& service, const std::string& signal, const std::string& event);
  void addMappings(const std::string& service, const std::map<std::string, std::string>& events);

  void describeReading(rpc::Service& service);
  void describeWriting(rpc::Service& service);
  void describeEvents(rpc::Service& service);
  void describeSubscribing(rpc::Service& service);
  void describeInner(rpc::Service& service);

  static constexpr std::size_t kForgetAt = 64;
  void forgetSubscribers();

  memory::Stamped read(const std::string& key) const;  // @throws CallError

  struct Awaited {
    std::string key;
    rpc::Value before;
    rpc::Pending<rpc::Value> pending;
  };

  memory::RobotMemory& memory_;
  AlMemoryCallbacks callbacks_;
  FindService find_service_;
  std::vector<Awaited> awaited_;
  std::map<std::string, std::weak_ptr<rpc::Service>> subscribers_;  // by event
  std::size_t forget_at_ = kForgetAt;                               // so many of them
  int mappings_ = 0;
};

}  // namespace nao::services
