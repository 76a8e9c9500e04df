#pragma once

#include <vector>

#include "validation/diagnosis/diagnose.h"
#include "validation/diagnosis/replay.h"
#include "validation/plot.h"

namespace nao::validation {

/// The effects that stand for what was found at a joint, at its `place` (JointSimulator::place),
/// those that all joints share included: numbers that were not fitted do nothing.
std::vector<EffectSetting> foundEffects(const SetDiagnosis& diagnosis, const JointVerdict& joint,
                                        const std::vector<Joint>& place);

/// One joint in one motion: mean of the repeats against mean of simulated runs.
struct JointCourse {
  std::string motion;
  double dt = 0;                                // [s]
  Eigen::VectorXd measured, nominal, extended;  // [rad] means
  Eigen::VectorXd floor;                        // [rad] SD of the measured mean
};

/// The fit or select motion in which the nominal model is furthest off, by `runs` runs each.
JointCourse worstCourse(const JointTask& task, const std::vector<EffectSetting>& found, int runs);

/// The angle, measured and simulated; below what is left of the error, in the band of noise.
Picture drawCourse(const JointCourse& course);

/// What each cause explains or would have explained [nats], the largest first, and the threshold.
Picture drawRanking(const JointVerdict& joint);

}  // namespace nao::validation
