#pragma once

#include <cstdint>
#include <string>

namespace nao::app {

/// One run of a scenario in this process.
struct ScenarioRun {
  std::string file;
  std::uint64_t seed = 1;
  double speed = 1;  // simulated seconds per second
  bool lockstep = true;
  std::string result;  // JSON file to write; empty: none
  std::string record;  // file of the recording; empty: none
};

/// Runs it, tells what failed, writes its result. Whether it passed.
/// @throws InputError for a broken scenario, and where its clients can not be run in lockstep.
bool runScenario(const ScenarioRun& run);

}  // namespace nao::app
