#pragma once

#include <string>
#include <vector>

#include "core/robot_model.h"
#include "validation/diagnosis/causes/causes.h"

namespace nao::validation {

/// A cause that a diagnosis tries, and where: "each joint", or joints, limbs, "robot".
struct ListedCause {
  Cause cause;
  std::vector<std::string> places;
};

/// What a level tries on a robot of which all joints were measured. `level`: joint, limb or robot;
/// at the joint level whatever the robot. @throws InputError for another level.
std::vector<ListedCause> listCauses(const std::string& level, const RobotModel& model);

/// One per line: id, numbers, places.
std::string toText(const std::vector<ListedCause>& causes);
/// An array of objects with id, effect, summary, numbers (each with name, unit, min, max, neutral,
/// smallest), places, said_as and told_apart_by.
std::string toJson(const std::vector<ListedCause>& causes);

/// A cause of any level at length. @throws InputError for an id that `model` has none of.
std::string showCause(const std::string& id, const RobotModel& model);

}  // namespace nao::validation
