#pragma once

#include <string>
#include <vector>

#include "core/robot_model.h"

namespace nao::validation {

/// Explanations between which a report could not choose, with their fitted numbers.
struct Ambiguity {
  std::string place;                    // as in the report: a joint, a limb, "robot"
  std::vector<std::string> causes;      // "kp_error", of a rival elsewhere "kp_error at LHipRoll"
  std::vector<EffectSetting> settings;  // by cause, on its joints
  std::string advice;                   // of the catalogue: what else would tell them apart
  std::string level = "joint";
};

/// Those of a report.json, place by place. @throws InputError if there are none.
std::vector<Ambiguity> ambiguitiesOf(const std::string& report_file, const RobotModel& model);

}  // namespace nao::validation
