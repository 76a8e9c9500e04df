#pragma once

#include <Eigen/Core>

namespace nao::validation {

/// Gauss-Newton steps along slopes that were simulated and so hold chance. Plain least squares
/// takes the chance in a slope for slope: its squares make every step short and every interval
/// narrow, down to a quarter for a weak cause in a joint with play. Two halves that share no random
/// number tell how much of the squares it is, and that much is left out.
class SlopeSteps {
 public:
  /// `slopes`: a whitened column per number, the mean of two halves; `chance`: half of what these
  /// differ by, in columns alike (zeros: slopes without chance).
  SlopeSteps(const Eigen::MatrixXd& slopes, const Eigen::MatrixXd& chance);

  /// By how much every number is to move, so that the least of the whitened residual is left.
  Eigen::VectorXd operator()(const Eigen::VectorXd& white) const;

 private:
  Eigen::MatrixXd basis_;    // orthonormal columns that span the slopes
  Eigen::MatrixXd numbers_;  // of a component along each of them
};

}  // namespace nao::validation
