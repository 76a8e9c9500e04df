#pragma once

#include <string>
#include <vector>

#include "core/robot_model.h"
#include "validation/diagnosis/extend/ambiguity.h"
#include "validation/log/simulated_recording.h"
#include "validation/report.h"

namespace nao::validation {

/// A motion that might tell them apart, and how far.
struct PlannedMotion {
  RecordedMotion motion;
  /// Least over pairs of causes: RMS difference of the predicted means over the SD of the mean of
  /// `repeats` runs.
  double separation = 0;
};

inline bool separatesMore(const PlannedMotion& a, const PlannedMotion& b) {
  return a.separation > b.separation;
}

/// Candidate motions of one joint, the others resting: slow and fast, small and large, held.
std::vector<RecordedMotion> candidateMotions(const std::shared_ptr<const RobotModel>& model,
                                             Joint joint);

/// All candidates, the best first: of a joint each simulated on its rig for every cause, else on
/// the whole robot.
std::vector<PlannedMotion> planExperiments(const std::shared_ptr<const RobotModel>& model,
                                           const Ambiguity& ambiguous, int repeats, int jobs);

Report reportPlan(const Ambiguity& ambiguous, const std::vector<PlannedMotion>& experiments,
                  const RobotModel& model, int repeats);

/// Writes a motion as a Webots .motion file, which `usarnaoqi play` plays: a pose every 40 ms.
/// @throws InputError if it can not be written.
void writeMotion(const RecordedMotion& motion, const RobotModel& model, const std::string& file);

}  // namespace nao::validation
