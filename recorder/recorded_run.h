#pragma once

#include <string>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"

namespace nao::recorder {

/// Seconds of a recording beside its motions.
inline constexpr double kGlide = 3;  // to the first pose: slow enough for any joint's way
inline constexpr double kRest = 1;   // before a motion: ten times what a joint takes to settle

/// A run without rows.
validation::LogRun makeRun(const std::string& motion, validation::Split split, int repeat,
                           const RobotModel& model);

/// A set without runs. `rate` [Hz]; `command_stamp`: what a command's time is, "executed" or
/// "sent".
validation::LogSet makeSet(const std::string& name, const RobotModel& model, double rate,
                           const std::string& command_stamp);

/// Leaves out what was before the commands began to change; the row before that is at time 0.
void startAtCommand(validation::LogRun& run);

}  // namespace nao::recorder
