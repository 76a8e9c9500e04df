#pragma once

#include <Eigen/Core>

namespace nao::validation {

/// Orthonormal columns that span what these do; none for columns of zeros.
Eigen::MatrixXd orthonormal(const Eigen::MatrixXd& columns);

/// What of x an orthonormal basis does not reach.
Eigen::VectorXd without(const Eigen::MatrixXd& basis, const Eigen::VectorXd& x);

}  // namespace nao::validation
