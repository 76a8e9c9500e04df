#pragma once

#include <memory>
#include <vector>

#include "validation/diagnosis/extend/optimise.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// optimise() of a robot on its feet, by replays of whole runs: angles, torso, weight on the soles
/// and the way it goes. `free` may hold numbers of the ground and the body too; "@each" is every
/// joint but those that such a replay can not judge.
/// @throws InputError for a number that the set does not show.
Optimised optimiseWhole(const LogSet& set, const std::shared_ptr<const RobotModel>& model,
                        const std::vector<FreeParameter>& free, const OptimiseOptions& options);

}  // namespace nao::validation
