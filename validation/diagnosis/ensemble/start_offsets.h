#pragma once

#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// Rate of a course of samples `dt` [s] apart, of a cubic spline through them; 0 at both ends. What
/// a late start looks like; rateOf() is smoother.
Eigen::VectorXd rateBetweenSamples(const Eigen::VectorXd& course, double dt);

/// Runs of one motion, each moved in time to where it is nearest to `reference`: when a run began
/// is known to `start_sd` [s] only, and is fitted wherever two means are compared. One by one runs
/// may have begun at any moment, their mean within three of its own SDs: a delay that all share is
/// no chance. First signals only, as long as the reference; `dt` [s] apart.
std::vector<Eigen::MatrixXd> startedAlike(std::vector<Eigen::MatrixXd> runs,
                                          const Eigen::VectorXd& reference, double dt,
                                          double start_sd);

}  // namespace nao::validation
