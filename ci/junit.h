#pragma once

#include <string>
#include <vector>

#include "ci/suite.h"

namespace nao::ci {

/// JUnit's XML, as GitHub, GitLab and Jenkins read it: a suite for each scenario, a case for each
/// seed. Equal runs give equal bytes but for the `time` of each, which is the wall's.
std::string toJUnit(const std::vector<JobResult>& results);

/// What failed, a line each: what was expected, what was seen, when.
std::vector<std::string> failuresOf(const Result& result);

/// The command that runs this again.
std::string replayCommand(const Result& result);

}  // namespace nao::ci
