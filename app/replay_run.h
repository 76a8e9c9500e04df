#pragma once

#include <string>
#include <vector>

namespace nao::app {

/// What `usarnaoqi replay` is told of a recorded run.
struct ReplayRunOptions {
  std::string file;
  double from = 0;               // [s]
  double to = 1e9;               // [s]
  std::vector<std::string> set;  // see validation::changeStart()
  std::string diff;              // another recording; empty: none
  std::string robot;             // whose signals are written; empty: the first
  std::string csv;               // written if not empty
  std::string set_out;           // likewise, a folder
  bool inputs = false;           // list them
};

/// Replays it and says how it went; false: not as it was recorded, or as the other.
bool replayRun(const ReplayRunOptions& options);

}  // namespace nao::app
