#pragma once

#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// Turns residuals into ones whose noise is white with SD 1: independent samples of SD `sd`, plus
/// disturbances along a few directions (`directions`: one per column, in the unit of the residual
/// for one SD of the disturbance), such as a late start or what equal robots differ by. Those
/// directions are not projected out but weighed by what they may well be.
class Whitening {
 public:
  Whitening() = default;
  Whitening(const Eigen::VectorXd& sd, const Eigen::MatrixXd& directions);

  Eigen::VectorXd operator()(const Eigen::VectorXd& residual) const;

  /// Without the directions: independent samples only.
  Eigen::VectorXd scaled(const Eigen::VectorXd& residual) const;

 private:
  Eigen::VectorXd scale_;
  Eigen::MatrixXd basis_;   // orthonormal columns, of scaled residuals
  Eigen::VectorXd shrink_;  // what is taken off along each
};

}  // namespace nao::validation
