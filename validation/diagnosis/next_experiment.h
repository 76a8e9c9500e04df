#pragma once

#include <string>
#include <vector>

#include "core/robot_model.h"
#include "validation/log/simulated_recording.h"
#include "validation/report.h"

namespace nao::validation {

/// Explanations of one joint between which a report could not choose, with their fitted numbers.
struct AmbiguousJoint {
  std::string joint;
  std::vector<std::string> causes;
  std::vector<EffectSetting> settings;  // by cause, on that joint
  std::string advice;                   // of the catalogue: what else would tell them apart
};
/// The ambiguous findings of a report.json, joint by joint. @throws InputError if there are none.
std::vector<AmbiguousJoint> ambiguousJoints(const std::string& report_file,
                                            const RobotModel& model);

/// A motion that might tell them apart, and how far.
struct PlannedMotion {
  RecordedMotion motion;
  /// Least over pairs of causes: RMS difference of the predicted means over the SD of the mean of
  /// `repeats` runs.
  double separation = 0;
};

/// Candidate motions of one joint, the others resting: slow and fast, small and large, held.
std::vector<RecordedMotion> candidateMotions(const std::shared_ptr<const RobotModel>& model,
                                             Joint joint);

/// All candidates, the best first: each simulated on the joint's rig for every cause.
std::vector<PlannedMotion> planExperiments(const std::shared_ptr<const RobotModel>& model,
                                           const AmbiguousJoint& ambiguous, int repeats, int jobs);

Report reportPlan(const AmbiguousJoint& ambiguous, const std::vector<PlannedMotion>& experiments,
                  const RobotModel& model, int repeats);

/// Writes a motion as a Webots .motion file, which `usarnaoqi play` plays: a pose every 40 ms.
/// @throws InputError if it can not be written.
void writeMotion(const RecordedMotion& motion, const RobotModel& model, const std::string& file);

}  // namespace nao::validation
