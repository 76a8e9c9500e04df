#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// What a fit varies, and how.
struct FitSpace {
  std::vector<double> start, lower, upper;
  std::vector<double> step;  // of the finite differences: wide enough to be more than roundings
  int iterations = 5;
  bool slopes = true;  // whether FitPoint::jacobian is wanted
  double part = 0.05;  // of a number, that its difference is at least

  /// A number that stays where it is; its column of the jacobian is 0.
  bool isFixed(std::size_t i) const { return lower[i] == upper[i]; }
};

/// The finite difference taken for the `i`-th number at `x`.
double differenceStep(const FitSpace& space, std::size_t i, double x);

struct FitPoint {
  std::vector<double> x;
  Eigen::VectorXd residual;  // there
  Eigen::MatrixXd jacobian;  // there, by finite differences; empty if not wanted
  double cost = 0;           // half the squares
  int evaluations = 0;
};

/// Minimises half the sum of squares of `residual(x)` within bounds (Ceres: trust region,
/// Levenberg-Marquardt). The residual may be rough as long as it is the same function at every
/// call.
FitPoint leastSquares(const std::function<Eigen::VectorXd(const std::vector<double>&)>& residual,
                      const FitSpace& space);

}  // namespace nao::validation
