#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/joint/prepared_set.h"

namespace nao::validation {

/// The unknowns of a report that have a signature: joint and the words of its features. Of a report
/// of several robots those of `robot_id`. Where a limb or a whole robot was searched, its signature
/// is the signals that remain most: joints, and others such as the torso's roll.
struct UnknownJoint {
  std::string joint;
  std::vector<std::string> features;  // as signature.h names them, best first; none: not told
};
/// @throws InputError for a file that is no report.json, or one whose joints have no signature.
std::vector<UnknownJoint> unknownJoints(const std::string& report_file,
                                        const std::string& robot_id = "");

/// @throws InputError if the set does not have it.
const PreparedJoint& jointOf(const PreparedSet& set, const std::string& joint);

/// What a joint's remainder beside the set's model goes with, as signature.h names it, where the
/// report does not tell; nothing without repeats. Takes as long as a joint in which nothing is
/// wrong.
std::vector<std::string> remainingFeatures(const PreparedJoint& joint);

/// The effect empirical_torque with these features, fitted to the joint's fit motions; what the
/// set's model has already stays. `error`: mean absolute error before and after [rad].
struct EmpiricalFit {
  EffectSetting setting;
  double before = 0, after = 0;
  std::vector<std::string> left_out;  // features that the effect does not have
};
EmpiricalFit fitEmpirical(const PreparedJoint& joint, const std::vector<std::string>& features);

}  // namespace nao::validation
