#pragma once

#include <vector>

#include <Eigen/Dense>

#include "core/archive.h"

namespace nao {

/// A strictly convex quadratic program:
///   minimize  1/2 x^T H x + g^T x   subject to  A_i x = b_i  for i < equalities,
///                                               A_i x >= b_i for the others.
struct QpProblem {
  Eigen::MatrixXd H;  // symmetric positive definite
  Eigen::VectorXd g;
  Eigen::MatrixXd A;  // one constraint a row
  Eigen::VectorXd b;
  int equalities = 0;
};

enum class QpStatus { Solved, Infeasible, Stalled };

struct QpSolution {
  QpStatus status = QpStatus::Stalled;
  Eigen::VectorXd x;
  /// One per constraint, 0 where it is not active, never below 0 for an inequality:
  /// H x + g = A^T multipliers.
  Eigen::VectorXd multipliers;
  int iterations = 0;
};

/// The dual active-set method of Goldfarb and Idnani (A numerically stable dual method for solving
/// strictly convex quadratic programs, Mathematical Programming 27, 1983), for dense problems of
/// some ten variables. It starts at the free minimum and takes in violated constraints one by one,
/// so that every iterate is optimal for the constraints it holds. Constraints that were active in
/// the solution before are taken in first: a problem like the one before ends after a few steps.
/// Memory is kept from call to call.
class QpSolver {
 public:
  /// Valid until the next call. Infeasible: `x` is where it gave up.
  const QpSolution& solve(const QpProblem& problem);

  /// Forgets which constraints were active: the next problem is not like the one before.
  void forget() { warm_.clear(); }

  /// Lists what the next call remembers of the last.
  void archive(Archive& archive) { archive.list(warm_); }

 private:
  void start(const QpProblem& problem);
  int findViolated(const QpProblem& problem) const;
  double slack(const QpProblem& problem, int row) const;
  bool takeIn(const QpProblem& problem, int row);
  void findDirections(const QpProblem& problem, int row);
  int findBlocking(double& longest) const;
  void add(int row);
  void drop(int position);

  QpSolution solution_;
  std::vector<int> active_;  // rows, in the order of the columns of r_
  std::vector<int> warm_;
  Eigen::MatrixXd j_;  // L^-T turned so that R = j_^T N is upper triangular
  Eigen::MatrixXd r_;
  Eigen::VectorXd d_, z_, dual_, multipliers_;
  std::vector<char> is_active_;
  std::vector<double> signs_;  // an equality approached from above is held from above
  Eigen::VectorXd norms_;
  int variables_ = 0;
};

}  // namespace nao
