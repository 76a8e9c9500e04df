#pragma once

#include <map>
#include <string>
#include <vector>

#include "ci/result.h"
#include "ci/scenario.h"

namespace nao::ci {

/// What a run needs beside its scenario.
struct ExecutorSettings {
  std::string robots_dir;
  std::string python_path;             // folder of the Python client
  std::vector<std::string> behaviors;  // folders of motions
  double speed = 1;                    // simulated seconds per second
  std::string record;                  // the run is written into this file; empty: into none
  /// Where clients see the world's time and take turns with it, and what they need to find it;
  /// null: they keep their own.
  clock::ClockPage* clock = nullptr;
  std::map<std::string, std::string> clock_environment;
};

/// The daemon's options for a scenario's world.
daemon::Options optionsFor(const Scenario& scenario, const ExecutorSettings& settings);

/// Runs a scenario's world and its clients until it is over.
Result execute(const Scenario& scenario, const ExecutorSettings& settings);

}  // namespace nao::ci
