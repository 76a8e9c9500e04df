#pragma once

#include <string>
#include <vector>

#include "core/robot_model.h"

namespace nao::validation {

/// What is taken out of a report.
struct Accepted {
  std::vector<std::string> causes;  // ids, rivals of named ones too; empty: all that is named alone
  std::string robot_id;             // of several robots in the set, this one; empty: the only one
};

/// The effects that a diagnosis of any level found, as they stand in its report.json: those of all
/// joints first, then place by place: the whole robot, limbs, joints. Their places name the report.
/// @throws InputError for a report that is not one, a robot it does not fit, an id it does not
/// hold, and for a report of which nothing can be accepted.
std::vector<EffectSetting> acceptedEffects(const std::string& report_file, const Accepted& accepted,
                                           const RobotModel& model);

/// What the report says that this robot differs by beside them: perhaps too little to be a cause,
/// place by place; without what is accepted by its id.
/// @throws InputError as above.
std::vector<EffectSetting> reportedAdjustments(const std::string& report_file,
                                               const Accepted& accepted, const RobotModel& model);

/// @throws InputError unless `name` can be that of a robot that is not there yet.
void requireNewRobot(const std::string& robots_dir, const std::string& name);

/// Writes the robot `name` beside `model` in `robots_dir`: like that one, with `causes` on top of
/// its effects. Returns the file. `origin`: where they come from, for the file's head.
/// @throws InputError if there is a robot of that name, or the file can not be written.
std::string writeExtendedRobot(const std::string& robots_dir, const std::string& name,
                               const RobotModel& model, const std::vector<EffectSetting>& causes,
                               const std::string& origin);

}  // namespace nao::validation
