#pragma once

#include "core/random.h"
#include "core/robot_model.h"
#include "sim/effects/catalogue.h"
#include "validation/diagnosis/replay/whole_run.h"

namespace nao::validation {

/// [rad] Where the links of a robot were when a run began: feet that stand hold the legs beside
/// their commands. Encoders see the motors; a motor that pushes is ahead of its link by half the
/// play of its gear, else nobody knows: `random` draws it if there is one. Joints that were not
/// measured are where they were told to be. `robot`: with the effects that act.
JointArray<double> startAngles(const RobotModel& robot, const WholeRun& measured,
                               const sim::EffectCatalogue& catalogue, Random* random);

}  // namespace nao::validation
