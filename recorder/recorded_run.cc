#include "recorder/recorded_run.h"

#include <cmath>
#include <cstddef>

namespace nao::recorder {

using validation::LogRun;
using validation::LogSet;

LogRun makeRun(const std::string& motion, validation::Split split, int repeat,
               const RobotModel& model) {
  LogRun run;
  run.motion = motion;
  run.split = split;
  run.repeat = repeat;
  run.file = "run_" + motion + "_" + std::to_string(repeat) + ".csv";
  run.robot_id = model.name;
  return run;
}

LogSet makeSet(const std::string& name, const RobotModel& model, double rate,
               const std::string& command_stamp) {
  LogSet set;
  set.name = name;
  set.robot = model.name;
  set.version = model.version;
  set.rate = rate;
  set.clock = {"robot", command_stamp, "measured"};
  return set;
}

void startAtCommand(LogRun& run) {
  constexpr double kChange = 2e-4;  // [rad] beyond what float32 does to a constant
  std::size_t first = run.t.size();
  for (const auto& [name, values] : run.columns) {
    if (name.rfind("cmd.", 0) != 0) continue;
    for (std::size_t i = 1; i < first; ++i) {
      if (std::abs(values[i] - values.front()) > kChange) first = i;
    }
  }
  if (first == run.t.size()) return;
  const double zero = run.t[first - 1];
  const auto cut = static_cast<std::ptrdiff_t>(first - 1);
  run.t.erase(run.t.begin(), run.t.begin() + cut);
  for (double& t : run.t) t -= zero;
  for (auto& [name, values] : run.columns) values.erase(values.begin(), values.begin() + cut);
}

}  // namespace nao::recorder
