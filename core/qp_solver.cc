#include "core/qp_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"

namespace nao {
namespace {

constexpr double kViolation = 1e-10;  // of a constraint whose row has length 1: rounding
constexpr double kDependent = 1e-12;  // squared length of what a constraint adds to the others
constexpr double kForever = std::numeric_limits<double>::infinity();

}  // namespace

const QpSolution& QpSolver::solve(const QpProblem& problem) {
  start(problem);
  const int most = 10 * (variables_ + static_cast<int>(problem.b.size()));
  for (solution_.iterations = 0; solution_.iterations < most;) {
    const int row = findViolated(problem);
    if (row < 0) {
      solution_.status = QpStatus::Solved;
      break;
    }
    if (takeIn(problem, row)) continue;
    solution_.status = QpStatus::Infeasible;
    break;
  }
  for (std::size_t k = 0; k < active_.size(); ++k) {
    const int row = active_[k];
    solution_.multipliers[row] =
        signs_[static_cast<std::size_t>(row)] * multipliers_[static_cast<long>(k)] / norms_[row];
  }
  warm_ = active_;
  return solution_;
}

void QpSolver::start(const QpProblem& problem) {
  variables_ = static_cast<int>(problem.g.size());
  const auto rows = problem.b.size();
  const Eigen::LLT<Eigen::MatrixXd> factors(problem.H);
  NAO_CHECK(factors.info() == Eigen::Success);
  j_.setIdentity(variables_, variables_);
  factors.matrixU().solveInPlace(j_);
  r_.setZero(variables_, variables_);
  solution_.status = QpStatus::Stalled;
  solution_.x = -factors.solve(problem.g);
  solution_.multipliers.setZero(rows);
  multipliers_.setZero(variables_ + 1);
  active_.clear();
  is_active_.assign(static_cast<std::size_t>(rows), 0);
  signs_.assign(static_cast<std::size_t>(rows), 1);
  norms_ = problem.A.rowwise().norm().cwiseMax(1e-300);
}

double QpSolver::slack(const QpProblem& problem, int row) const {
  return (problem.A.row(row).dot(solution_.x) - problem.b[row]) / norms_[row];
}

// Equalities first, then what was active before, then the worst.
int QpSolver::findViolated(const QpProblem& problem) const {
  for (int i = 0; i < problem.equalities; ++i) {
    if (!is_active_[static_cast<std::size_t>(i)]) return i;
  }
  for (const int i : warm_) {
    if (i >= problem.b.size() || is_active_[static_cast<std::size_t>(i)]) continue;
    if (slack(problem, i) < -kViolation) return i;
  }
  int worst = -1;
  double least = -kViolation;
  for (int i = problem.equalities; i < problem.b.size(); ++i) {
    if (is_active_[static_cast<std::size_t>(i)]) continue;
    const double s = slack(problem, i);
    if (s < least) {
      least = s;
      worst = i;
    }
  }
  return worst;
}

// z_: how x moves, dual_: how the active multipliers fall, per unit of the new one's rise.
void QpSolver::findDirections(const QpProblem& problem, int row) {
  const auto q = static_cast<long>(active_.size());
  const double sign = signs_[static_cast<std::size_t>(row)] / norms_[row];
  d_.noalias() = sign * (j_.transpose() * problem.A.row(row).transpose());
  z_.noalias() = j_.rightCols(variables_ - q) * d_.tail(variables_ - q);
  dual_ = d_.head(q);
  r_.topLeftCorner(q, q).triangularView<Eigen::Upper>().solveInPlace(dual_);
}

// The active inequality whose multiplier reaches 0 first.
int QpSolver::findBlocking(double& longest) const {
  int blocking = -1;
  for (long k = 0; k < dual_.size(); ++k) {
    const int row = active_[static_cast<std::size_t>(k)];
    if (dual_[k] <= 0 || is_active_[static_cast<std::size_t>(row)] == 2) continue;
    const double step = multipliers_[k] / dual_[k];
    if (step >= longest) continue;
    longest = step;
    blocking = static_cast<int>(k);
  }
  return blocking;
}

// Moves until constraint `row` holds, letting go of others on the way. False: it never can.
bool QpSolver::takeIn(const QpProblem& problem, int row) {
  const bool equality = row < problem.equalities;
  double missing = -slack(problem, row);
  if (equality && missing < 0) {
    signs_[static_cast<std::size_t>(row)] = -1;
    missing = -missing;
  }
  double risen = 0;
  for (;; ++solution_.iterations) {
    findDirections(problem, row);
    const auto q = static_cast<long>(active_.size());
    const double rate = d_.tail(variables_ - q).squaredNorm();  // slack won per unit
    const bool moves = rate > kDependent * std::max(1.0, d_.squaredNorm());
    double step = moves ? missing / rate : kForever;
    const int blocking = findBlocking(step);
    if (step == kForever) {  // an equality may say what others say already
      is_active_[static_cast<std::size_t>(row)] = equality ? 2 : 0;
      return equality && missing < kViolation;
    }
    multipliers_.head(q) -= step * dual_;
    risen += step;
    if (moves) {
      solution_.x += step * z_;
      missing -= step * rate;
    }
    if (blocking < 0) {
      multipliers_[q] = risen;
      add(row);
      is_active_[static_cast<std::size_t>(row)] = equality ? 2 : 1;
      ++solution_.iterations;
      return true;
    }
    drop(blocking);
  }
}

// Turns the free columns of j_ until the new constraint acts along the first of them alone.
void QpSolver::add(int row) {
  const auto q = static_cast<long>(active_.size());
  Eigen::JacobiRotation<double> turn;
  for (long k = variables_ - 1; k > q; --k) {
    turn.makeGivens(d_[k - 1], d_[k], &d_[k - 1]);
    d_[k] = 0;
    j_.applyOnTheRight(k - 1, k, turn);
  }
  r_.col(q).head(q + 1) = d_.head(q + 1);
  active_.push_back(row);
}

void QpSolver::drop(int position) {
  is_active_[static_cast<std::size_t>(active_[static_cast<std::size_t>(position)])] = 0;
  active_.erase(active_.begin() + position);
  const auto q = static_cast<long>(active_.size());
  for (long k = position; k < q; ++k) {
    r_.col(k).head(k + 2) = r_.col(k + 1).head(k + 2);
    multipliers_[k] = multipliers_[k + 1];
  }
  Eigen::JacobiRotation<double> turn;
  for (long k = position; k < q; ++k) {  // what stands below the diagonal goes
    turn.makeGivens(r_(k, k), r_(k + 1, k));
    r_.block(0, k, q + 1, q - k).applyOnTheLeft(k, k + 1, turn.adjoint());
    r_(k + 1, k) = 0;
    j_.applyOnTheRight(k, k + 1, turn);
  }
}

}  // namespace nao
