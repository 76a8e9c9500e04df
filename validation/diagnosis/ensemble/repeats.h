#pragma once

#include <Eigen/Core>

#include "validation/diagnosis/ensemble/joint_simulator.h"

namespace nao::validation {

/// Rate of change of an angle [rad/s] by central differences over a few rows, fewer at the ends, so
/// that counts of an encoder do not matter.
Eigen::VectorXd rateOf(const Eigen::VectorXd& angle, double dt);
/// By how much a run came late [s], as its deviation from the mean shows where the mean moves.
double latenessOf(const Eigen::VectorXd& deviation, const Eigen::VectorXd& rate);

/// What the repeats of one motion say: their mean, and how well it is known. Columns are signals.
struct RepeatStatistics {
  Eigen::MatrixXd mean;
  /// SD of one run at every sample, smoothed over 0.2 s, as few repeats do not know it better. What
  /// runs differ by as they come late is taken off: that is a number of its own in every fit.
  Eigen::MatrixXd sd;
  /// Samples per independent one, by signal: 1 + 2 sum of the deviations' autocorrelation.
  Eigen::VectorXd inflation;
  int repeats = 0;
};

RepeatStatistics statisticsOf(const JointMotion& motion);

/// The same with the deviations of simulated runs, for a motion that was measured once only.
RepeatStatistics statisticsOf(const JointMotion& motion,
                              const std::vector<Eigen::MatrixXd>& simulated);

/// Half the difference between the means of two halves of the repeats: noise of the mean without
/// any cause in it. `split` chooses the halves; they differ for 0 <= split < splitCount(repeats).
Eigen::MatrixXd halfDifference(const JointMotion& motion, int split);
int splitCount(int repeats);

}  // namespace nao::validation
