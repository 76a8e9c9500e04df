#pragma once

#include <string>
#include <vector>

#include "validation/log/robot_log.h"

namespace nao::validation {

/// The robots of a set's runs (LogRun::robot_id), in the order of their first ones.
std::vector<std::string> robotsOf(const LogSet& set);

/// The set with the runs of one of them alone.
LogSet runsOf(const LogSet& set, const std::string& robot_id);

/// For what replays a whole robot: the runs of this one; with `robot_id` empty all of them, which
/// must be of one robot unless it is hung up. @throws InputError with the robots that there are.
LogSet runsOfOne(const LogSet& set, const std::string& robot_id);

}  // namespace nao::validation
