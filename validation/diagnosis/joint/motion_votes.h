#pragma once

#include <vector>

#include <Eigen/Core>

#include "validation/diagnosis/joint/candidate_fit.h"

namespace nao::validation {

class JointData;

/// Where each fit motion by itself would move the numbers that fit a residual `raw` best: a row
/// per motion, a column per number; columns add up to nothing.
/// `steps`: stepsOf the fit.
Eigen::MatrixXd votesOf(const JointData& data, const Stage& stage, const ModelSlopes& fit,
                        const SlopeSteps& steps, const Eigen::VectorXd& raw);

/// The variance of each number that motions tell by disagreeing more than those of null sets do:
/// a law that is only like the robot's own fits each motion best with another number. Nothing with
/// less than two motions.
Eigen::VectorXd disagreement(const Eigen::MatrixXd& votes,
                             const std::vector<Eigen::MatrixXd>& votes_of_nulls);

}  // namespace nao::validation
