#pragma once

#include <Eigen/Core>

namespace nao::validation {

/// A matrix as left * values * right^T: columns of the one and the other are orthonormal, as many
/// as the matrix has rows or columns, the fewer of the two; values descend.
struct ThinSvd {
  Eigen::MatrixXd left;
  Eigen::VectorXd values;
  Eigen::MatrixXd right;  // empty: was not asked for
};

enum class Right { Wanted, Unwanted };

/// Eigen's, compiled once: half a minute where it is included.
ThinSvd calcSvd(const Eigen::MatrixXd& matrix, Right right = Right::Unwanted);

}  // namespace nao::validation
