#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "naoqi_api/memory/memory_store.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// NaoQi's ALSystem: the robot's name, versions, memory and disks of the host it is simulated on.
/// What would change or stop the host is refused. I/O thread.
class AlSystem {
 public:
  /// @param memory where RobotNameChanged is raised; outlives it
  /// @param name the robot's, until a client renames it
  AlSystem(memory::MemoryStore& memory, std::string name);

  /// The service; this object must outlive it.
  rpc::Service describe();

 private:
  std::string robotName() { return name_; }
  bool setRobotName(const std::string& name);
  std::string systemVersion();
  std::string previousSystemVersion() { return {}; }
  rpc::Value systemInfo();
  std::string timezone() { return timezone_; }
  bool setTimezone(const std::string& timezone);
  std::int32_t freeMemory();
  std::int32_t totalMemory();
  std::vector<rpc::Value> diskFree(bool all);

  memory::MemoryStore& memory_;
  std::string name_;
  std::string timezone_ = "UTC";
};

}  // namespace nao::services
