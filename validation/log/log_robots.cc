#include "validation/log/log_robots.h"

#include <algorithm>

#include "core/check.h"

namespace nao::validation {

std::vector<std::string> robotsOf(const LogSet& set) {
  std::vector<std::string> robots;
  for (const LogRun& run : set.runs) {
    if (std::find(robots.begin(), robots.end(), run.robot_id) == robots.end()) {
      robots.push_back(run.robot_id);
    }
  }
  return robots;
}

LogSet runsOf(const LogSet& set, const std::string& robot_id) {
  LogSet part = set;
  const auto other = [&](const LogRun& run) { return run.robot_id != robot_id; };
  part.runs.erase(std::remove_if(part.runs.begin(), part.runs.end(), other), part.runs.end());
  return part;
}

LogSet runsOfOne(const LogSet& set, const std::string& robot_id) {
  const std::vector<std::string> robots = robotsOf(set);
  if (robot_id.empty() && (robots.size() <= 1 || set.environment.suspended)) return set;
  if (std::find(robots.begin(), robots.end(), robot_id) != robots.end()) {
    return runsOf(set, robot_id);
  }
  std::string all;
  for (const std::string& robot : robots) all += (all.empty() ? "" : ", ") + robot;
  throw InputError(set.name + ": --robot-id: expected one of " + all + ", found '" + robot_id +
                   "'");
}

}  // namespace nao::validation
