#pragma once

#include <memory>
#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "sim/effects/catalogue.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// Adds to a run what a simulated robot was told and sensed at `t` [s], and where its torso really
/// was: a row of all columns.
void addRow(const RobotModel& robot, double t, const SensorFrame& sensors,
            const JointCommand& command, const Pose& X_WT, LogRun& run);

/// A set of a simulated robot on its feet, without runs.
LogSet simulatedSet(const RobotModel& robot);

/// The robot as it is, but for `extra` on top of its own effects (merge_effects.h): nothing of it
/// is drawn anew. `catalogue`: null: standardEffects().
std::shared_ptr<const RobotModel> withEffects(const RobotModel& robot,
                                              const std::vector<EffectSetting>& extra,
                                              const sim::EffectCatalogue* catalogue);

}  // namespace nao::validation
