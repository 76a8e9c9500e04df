#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/robot_model.h"

namespace nao::validation {

/// Gives `take` what a diagnosis wrote into its report.json.
/// @throws InputError if it can not be read, is none, or lacks what `take` asks it for.
void readReport(const std::string& file, const std::function<void(const nlohmann::json&)>& take);

/// The nominal robot of a report. `wanted`: what the user calls it; empty: as the report says.
/// @throws InputError if the user calls it otherwise.
std::string reportedModel(const std::string& file, const std::string& wanted);

/// Where something was found: "LHipPitch", "LLeg", "robot"; "7/LHipPitch" in a report of several
/// robots.
struct ReportedPlace {
  explicit ReportedPlace(const std::string& text);
  std::string robot_id, name;
};

/// "kp_error", of a rival elsewhere "kp_error at LHipRoll".
struct ReportedCause {
  explicit ReportedCause(const std::string& text);
  std::string id, place;  // place empty: where its finding is
};

/// The effect of a finding, an adjustment or a rival; where none is written, its cause's id says
/// it.
std::string effectOf(const nlohmann::json& cause);

/// The joints of a place of this report; none: all that the robot has.
/// @throws InputError for a place that the robot does not have.
std::vector<Joint> jointsAt(const std::string& place, const std::string& file,
                            const RobotModel& model);

}  // namespace nao::validation
