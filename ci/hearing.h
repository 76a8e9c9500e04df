#pragma once

#include <memory>
#include <vector>

#include "ci/moment.h"
#include "ci/scenario.h"
#include "naoqi_api/memory/robot_memory.h"

namespace nao::ci {

/// Listens to the robots' memories for what a scenario's expectations ask for. I/O thread.
class Hearing {
 public:
  /// `memories` by robot; they outlive it.
  Hearing(const Scenario& scenario, std::vector<memory::RobotMemory*> memories);

  /// What was raised since the last time, and what memory holds now.
  Heard take();

 private:
  void listen(std::size_t robot, const std::string& key);

  std::vector<memory::RobotMemory*> memories_;
  std::vector<std::pair<std::size_t, std::string>> keys_;  // to read
  std::vector<HeardEvent> events_;
  std::vector<std::shared_ptr<void>> listeners_;
};

}  // namespace nao::ci
