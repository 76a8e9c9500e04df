#pragma once

#include <memory>
#include <vector>

#include "validation/diagnosis/ensemble/noise_fit.h"
#include "validation/diagnosis/joint/diagnose.h"
#include "validation/diagnosis/rig/rig_simulator.h"

namespace nao::validation {

/// A joint of a set, ready to be replayed or diagnosed.
struct PreparedJoint {
  std::unique_ptr<RigSimulator> simulator;
  JointNoise nominal;       // of the robot's file
  NoiseComparison moments;  // measured, and simulated with the nominal noise
  JointNoise noise;         // fitted to the repeats
};

struct PreparedSet {
  std::shared_ptr<const RigSet> set;
  std::vector<PreparedJoint> joints;  // that were commanded and measured
};

/// Puts all joints of a set on rigs and fits their noise to the repeats. `jobs`: threads; the
/// result is the same for any number. @throws InputError as RigSet does.
PreparedSet prepareSet(const LogSet& set, std::shared_ptr<const RobotModel> model, int jobs,
                       RigOptions options = {});
/// The same for a diagnosis, with its team and what it keeps; without moments.
PreparedSet prepareSet(const LogSet& set, std::shared_ptr<const RobotModel> model,
                       const DiagnosisOptions& options);

}  // namespace nao::validation
