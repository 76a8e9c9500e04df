#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "naoqi_api/memory/robot_memory.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/tasks.h"

namespace nao::services {

/// What the services of one robot share. All of it outlives them.
struct ServiceContext {
  RobotLink& link;
  memory::RobotMemory& memory;
  rpc::CallLater later;                          // simulated time
  std::function<void(const std::string&)> log;   // what a robot would be seen or heard to do
  std::function<void(const std::string&)> warn;  // what is left out, a sentence
  std::filesystem::path data_dir;                // clients' files; empty: they have none
  std::string robot_name;                        // as its user named it

  memory::MemoryStore& store() const { return memory.store(); }
};

}  // namespace nao::services
