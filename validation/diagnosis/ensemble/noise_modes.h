#pragma once

#include <Eigen/Core>

#include "validation/diagnosis/ensemble/ensemble.h"

namespace nao::validation {

/// How the mean of a motion's repeats varies: more than independent noise of samples says. A whole
/// hold is a little higher in one run than in the next, a spike of current falls on this row or
/// the next one.
struct NoiseModes {
  Eigen::VectorXd sd;          // of each sample of the measured mean, beside the modes
  Eigen::MatrixXd directions;  // one SD of the difference of two means, a column per mode
};

/// Reads them off the runs of a pool, for a prediction as certain as a mean of `worth` runs. `sd`
/// is what repeats say of each sample: it is kept where the pool does not say more.
NoiseModes findNoiseModes(const RunPool& pool, double worth, const JointData& data,
                          const Eigen::VectorXd& sd);

}  // namespace nao::validation
