#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "ci/suite.h"
#include "core/robot_model.h"

namespace nao::ci {

/// A page that needs no other file: all runs in a table, then for each that failed what was
/// expected, seen and when, pictures, tracks and joints of its last seconds, what was printed, and
/// the command that runs it again. `model_of` gives a robot by the name of its model.
/// @throws InputError without gnuplot.
std::string toPage(
    const std::vector<JobResult>& results,
    const std::function<std::shared_ptr<const RobotModel>(const std::string&)>& model_of);

}  // namespace nao::ci
