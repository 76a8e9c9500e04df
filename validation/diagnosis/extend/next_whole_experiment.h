#pragma once

#include "validation/diagnosis/extend/next_experiment.h"

namespace nao::validation {

/// As planExperiments(), for what a limb or the whole robot left open: the standard motions of a
/// robot that hangs, or of one that stands, each simulated on the whole robot for every cause. The
/// separation is that of the signal which tells most (an angle, the torso's tilt, the weight on a
/// sole ...).
std::vector<PlannedMotion> planWholeExperiments(const std::shared_ptr<const RobotModel>& model,
                                                const Ambiguity& ambiguous, int repeats, int jobs);

}  // namespace nao::validation
