#pragma once

#include <string>
#include <vector>

#include "validation/diagnosis/ensemble/joint_simulator.h"

namespace nao::validation {

/// How far the model is from the measurement of one joint's angle, over some motions. When a run
/// began is fitted wherever two are compared, within what its noise lets starts differ by.
struct JointReplay {
  std::string joint;
  double rmse = 0;          // [rad] mean of the repeats against mean of the simulated runs
  double mae = 0;           // [rad] the same, mean of absolute values
  double floor = 0;         // [rad] SD of the mean of the repeats: what noise alone leaves
  double misfit = 0;        // rmse over what the spreads of both means explain; 1: nothing is wrong
  double share = 0;         // of the squared error that noise does not explain
  double real_sd = 0;       // [rad] of one run about the mean, measured
  double simulated_sd = 0;  // [rad] the same of the model with this noise
  double noise_free_rmse = 0;  // [rad] against one run without noise
};

/// Runs of a joint in the motions of some splits, by JointSimulator::measured(): a motion of
/// another split has none.
struct ReplayedRuns {
  std::vector<std::vector<Eigen::MatrixXd>> noisy;  // in mirrored pairs (run_noise.h)
  std::vector<Eigen::VectorXd> noise_free;          // [rad] the angle
};

/// Replays the commands of the motions of these splits on the model with `causes` and its noise,
/// `runs` times each, or up to three times more: multiples of four mirror each other, and 8 make as
/// certain a mean as 30 that do not.
ReplayedRuns replayRuns(const JointSimulator& joint, const std::vector<EffectSetting>& causes,
                        const JointNoise& noise, int runs, const std::vector<Split>& splits);
/// What they are beside the measurement; starts differ by `start_sd` [s].
JointReplay compareReplay(const JointSimulator& joint, const ReplayedRuns& runs, double start_sd);
/// Both.
JointReplay replayJoint(const JointSimulator& joint, const std::vector<EffectSetting>& causes,
                        const JointNoise& noise, int runs, const std::vector<Split>& splits);

/// What a JointReplay is made of: sums over the samples of all motions, squares but for `absolute`.
struct ReplaySums {
  double error = 0, absolute = 0, explained = 0, floor = 0, real = 0, simulated = 0, noise_free = 0;
  double samples = 0;

  JointReplay finish(const std::string& joint) const;
};

/// Mean and squared deviations of some runs of one signal; unbiased, 0 with a single run.
struct RunSpread {
  Eigen::VectorXd mean;
  Eigen::VectorXd variance;  // of one run
  Eigen::VectorXd of_mean;   // of the mean
};
/// Of runs that know nothing of each other.
RunSpread spreadOf(const std::vector<Eigen::MatrixXd>& runs, Eigen::Index signal);
/// Of ReplayedRuns' of a motion.
RunSpread spreadOfPairs(const std::vector<Eigen::MatrixXd>& runs, Eigen::Index signal);

}  // namespace nao::validation
