#pragma once

#include <Eigen/Core>

namespace nao::validation {

/// The mean of each value and `beside` others to either side, fewer at the ends.
Eigen::VectorXd movingMean(const Eigen::VectorXd& x, Eigen::Index beside);

}  // namespace nao::validation
