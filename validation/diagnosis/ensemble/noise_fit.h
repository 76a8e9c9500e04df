#pragma once

#include <string>
#include <vector>

#include "core/robot_model.h"
#include "validation/diagnosis/ensemble/joint_simulator.h"

namespace nao::validation {

/// The noise of one joint as its robot's file states it, or else what is usual.
JointNoise nominalNoise(const RobotModel& model, Joint joint);

/// What repeats say of a joint's noise, without any model: second moments of the deviations from
/// the mean of the repeats.
struct NoiseMoments {
  double sd = 0;        // [rad] of a run about the mean
  double start_sd = 0;  // [s] of runs that come early or late, by how they differ where it moves
  /// [rad^2] Covariance of what is left with itself, 0, 1, 2 ... rows later.
  std::vector<double> covariance;
};
NoiseMoments momentsOf(const std::vector<JointMotion>& motions);

/// The measured moments beside those of the joint's simulated repeats under `noise`: as many as
/// were measured, of the motions that are not test.
struct NoiseComparison {
  NoiseMoments measured, simulated;
};
NoiseComparison compareNoise(const JointSimulator& joint, const JointNoise& noise);

/// The noise with which simulated repeats, of the model with `causes`, have the measured ones'
/// moments in most seconds: torque and its correlation time, starts, jitter. `first` is where it
/// begins; motions without repeats say nothing, and if all are, `first` is the answer.
JointNoise fitNoise(const JointSimulator& joint, const JointNoise& first,
                    const std::vector<EffectSetting>& causes = {});

}  // namespace nao::validation
