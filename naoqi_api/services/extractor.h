#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "naoqi_api/memory/memory_store.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// What NaoQi's extractors have in common: clients subscribe to them, each with a period and a
/// precision, and they work while somebody does. A subscription stays when its client has gone, as
/// on the robot. I/O thread.
class Extractor {
 public:
  /// What it writes to memory.
  struct Outputs {
    std::vector<std::string> events;  // are declared
    std::vector<std::string> keys;
  };

  Extractor(memory::MemoryStore& store, std::string name, Outputs outputs);

  /// Adds subscribe() and its like; this object must outlive the service.
  void declare(rpc::Service& service);

  /// Somebody has subscribed, and it is not paused.
  bool isWorking() const { return !subscribers_.empty() && !paused_; }

  /// Called when isWorking() changes.
  void onWorking(std::function<void(bool)> changed) { changed_ = std::move(changed); }

  static constexpr std::size_t kMostSubscribers = 256;

 private:
  struct Subscriber {
    std::int32_t period = 30;  // [ms]
    float precision = 1;       // 0 to 1
  };
  void subscribe(const std::string& name, const Subscriber& subscriber);
  void unsubscribe(const std::string& name);
  Subscriber& at(const std::string& name);
  void pause(bool on);
  void tell(bool was_working) const;
  void declareSubscribing(rpc::Service& service);
  void declareAsking(rpc::Service& service);

  std::string name_;
  Outputs outputs_;
  std::map<std::string, Subscriber> subscribers_;
  bool paused_ = false;
  std::function<void(bool)> changed_;
};

}  // namespace nao::services
