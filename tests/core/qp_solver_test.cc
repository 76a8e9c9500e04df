#include "core/qp_solver.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "core/random.h"

namespace nao {
namespace {

Eigen::VectorXd randomVector(long size, Random& random) {
  Eigen::VectorXd v(size);
  for (double& x : v) x = random.normal();
  return v;
}

// Feasible by making: its constraints hold at some point, a third of them just.
QpProblem randomProblem(int variables, int rows, int equalities, Random& random) {
  QpProblem problem;
  Eigen::MatrixXd root(variables, variables);
  for (double& x : root.reshaped()) x = random.normal();
  problem.H = root * root.transpose() + 0.1 * Eigen::MatrixXd::Identity(variables, variables);
  problem.g = 3 * randomVector(variables, random);
  problem.A.resize(rows, variables);
  for (double& x : problem.A.reshaped()) x = random.normal();
  problem.b = problem.A * randomVector(variables, random);
  for (int i = equalities; i < rows; ++i) {
    if (random.uniform() < 2.0 / 3) problem.b[i] -= random.uniform(0, 2);
  }
  problem.equalities = equalities;
  return problem;
}

// The largest violation of the conditions of Karush, Kuhn and Tucker, against the problem's size.
double residual(const QpProblem& p, const QpSolution& s) {
  const double size = std::max(1.0, p.g.cwiseAbs().maxCoeff());
  double worst = (p.H * s.x + p.g - p.A.transpose() * s.multipliers).cwiseAbs().maxCoeff() / size;
  const Eigen::VectorXd slack = p.A * s.x - p.b;
  for (int i = 0; i < slack.size(); ++i) {
    if (i < p.equalities) {
      worst = std::max(worst, std::abs(slack[i]));
      continue;
    }
    worst = std::max({worst, -slack[i], -s.multipliers[i] / size});
    worst = std::max(worst, std::abs(slack[i] * s.multipliers[i]) / size);
  }
  return worst;
}

TEST(QpSolver, MeetsTheConditionsOfOptimality) {
  Random random(1);
  QpSolver solver;
  for (int trial = 0; trial < 10000; ++trial) {
    const int n = 2 + trial % 29;
    const int equalities = trial % 3 == 0 ? trial % std::max(1, n / 3) : 0;
    const QpProblem problem = randomProblem(n, equalities + trial % 41, equalities, random);
    if (trial % 2) solver.forget();
    const QpSolution& solution = solver.solve(problem);
    ASSERT_EQ(solution.status, QpStatus::Solved) << trial;
    ASSERT_LT(residual(problem, solution), 1e-8) << trial << ", " << n << " variables";
  }
}

// Another solver: tries every set of active constraints and keeps the best feasible point.
double bruteForce(const QpProblem& p) {
  const long n = p.g.size();
  const long m = p.b.size();
  double best = std::numeric_limits<double>::infinity();
  for (unsigned set = 0; set < 1U << m; ++set) {
    std::vector<int> rows;
    for (int i = 0; i < m; ++i) {
      if (set >> i & 1U) rows.push_back(i);
    }
    const auto q = static_cast<long>(rows.size());
    if (q > n) continue;
    Eigen::MatrixXd kkt = Eigen::MatrixXd::Zero(n + q, n + q);
    Eigen::VectorXd rhs(n + q);
    kkt.topLeftCorner(n, n) = p.H;
    rhs.head(n) = -p.g;
    for (long k = 0; k < q; ++k) {
      kkt.row(n + k).head(n) = p.A.row(rows[static_cast<std::size_t>(k)]);
      kkt.col(n + k).head(n) = kkt.row(n + k).head(n).transpose();
      rhs[n + k] = p.b[rows[static_cast<std::size_t>(k)]];
    }
    const Eigen::VectorXd x = kkt.fullPivLu().solve(rhs).head(n);
    if ((p.A * x - p.b).minCoeff() < -1e-7) continue;
    best = std::min(best, 0.5 * x.dot(p.H * x) + p.g.dot(x));
  }
  return best;
}

TEST(QpSolver, FindsWhatTryingEverythingFinds) {
  Random random(2);
  QpSolver solver;
  for (int trial = 0; trial < 300; ++trial) {
    const QpProblem p = randomProblem(2 + trial % 4, 1 + trial % 8, 0, random);
    const Eigen::VectorXd x = solver.solve(p).x;
    const double found = 0.5 * x.dot(p.H * x) + p.g.dot(x);
    EXPECT_NEAR(found, bruteForce(p), 1e-6 * std::max(1.0, std::abs(found))) << trial;
  }
}

TEST(QpSolver, SaysWhenThereIsNoSolution) {
  QpProblem problem;
  problem.H = Eigen::MatrixXd::Identity(2, 2);
  problem.g = Eigen::VectorXd::Zero(2);
  problem.A.resize(2, 2);
  problem.A << 1, 0, -1, 0;
  problem.b = Eigen::Vector2d(1, 1);  // x >= 1 and x <= -1
  EXPECT_EQ(QpSolver().solve(problem).status, QpStatus::Infeasible);
  problem.equalities = 2;
  EXPECT_EQ(QpSolver().solve(problem).status, QpStatus::Infeasible);
}

TEST(QpSolver, TakesConstraintsThatSayTheSameTwice) {
  QpProblem problem;
  problem.H = Eigen::MatrixXd::Identity(2, 2);
  problem.g = Eigen::VectorXd::Zero(2);
  problem.A.resize(4, 2);
  problem.A << 1, 0, 1, 0, 2, 0, 0, 1;
  problem.b = Eigen::Vector4d(1, 1, 2, -1);
  for (const int equalities : {0, 2}) {
    problem.equalities = equalities;
    QpSolver solver;
    const QpSolution& solution = solver.solve(problem);
    EXPECT_EQ(solution.status, QpStatus::Solved);
    EXPECT_NEAR(solution.x[0], 1, 1e-12);
    EXPECT_NEAR(solution.x[1], 0, 1e-12);
  }
}

// Like the one before: the constraints that were active are taken in at once.
TEST(QpSolver, NeedsFewStepsForAProblemLikeTheOneBefore) {
  Random random(3);
  QpSolver warm;
  int saved = 0;
  for (int trial = 0; trial < 100; ++trial) {
    QpProblem problem = randomProblem(30, 60, 0, random);
    warm.forget();
    warm.solve(problem);
    problem.g *= 1.001;
    QpSolver cold;
    saved += cold.solve(problem).iterations - warm.solve(problem).iterations;
  }
  EXPECT_GT(saved, 0);
}

}  // namespace
}  // namespace nao
