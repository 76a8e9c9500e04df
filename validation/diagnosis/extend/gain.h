#pragma once

#include <memory>
#include <string>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"
#include "validation/report.h"

namespace nao::validation {

struct GainOptions {
  int runs = 32;  // simulated per motion, at least
  int jobs = 1;   // threads; the result is the same
};

/// `usarnaoqi gain`: how much nearer `after` comes than `before` to the test runs of a set, which
/// nothing else looks at: error of the mean of the simulated runs against the mean of the repeats,
/// per joint and over all, beside the floor that the repeats' own spread leaves; and where it got
/// worse. Of a robot on its feet also where it went and how it swayed. `openings`: how often the
/// test runs have been looked at, this time included.
/// @throws InputError if the two robots do not have the same joints.
Report measureGain(const LogSet& set, std::shared_ptr<const RobotModel> before,
                   std::shared_ptr<const RobotModel> after, int openings,
                   const GainOptions& options);

/// Where a set's looks at its test runs are written down, a line each. Not part of the set's data.
std::string testOpeningsFile(const std::string& set_folder);

/// @throws InputError for a set without test runs, and if that file can not be written.
void requireOpenable(const LogSet& set, const std::string& set_folder);

/// Adds a line to it: somebody is shown what the test runs say. Errors as requireOpenable().
void openTestRuns(const LogSet& set, const std::string& set_folder, const std::string& by);

/// How often that was, so far.
int countTestOpenings(const std::string& set_folder);

}  // namespace nao::validation
