#include "sim/tree_matrix.h"

#include <gtest/gtest.h>

#include "core/random.h"

namespace nao::sim {
namespace {

// A trunk of three with two branches, filled by random forces at the leaves.
struct Filled {
  TreeMatrix tree{{-1, 0, 1, 2, 3, 2, 5}};
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(7, 7);
};

Filled randomMatrix() {
  Filled out;
  Random random(1);
  out.tree.addDiagonal(Eigen::VectorXd::Constant(7, 0.1));
  out.dense.diagonal().setConstant(0.1);
  for (const int leaf : {4, 6, 4, 6, 3}) {
    std::vector<double> row;
    Eigen::VectorXd full = Eigen::VectorXd::Zero(7);
    for (int c = 0; c < out.tree.depth(leaf); ++c) {
      full[out.tree.chain(leaf)[c]] = row.emplace_back(random.normal());
    }
    out.tree.addOuterProduct(leaf, row.data(), 0.5);
    out.dense += 0.5 * full * full.transpose();
  }
  return out;
}

TEST(TreeMatrix, OuterProductsFillTheLowerTriangle) {
  const Filled m = randomMatrix();
  for (int i = 0; i < 7; ++i) {
    for (int j = i; j >= 0; j = m.tree.parent(j))
      EXPECT_NEAR(m.tree.at(i, j), m.dense(i, j), 1e-14);
  }
}

TEST(TreeMatrix, SolvesAsADenseSolverDoes) {
  Filled m = randomMatrix();
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(7, -1, 2);
  Eigen::VectorXd x = b;
  m.tree.factor();
  m.tree.solve(x);
  EXPECT_LT((m.dense * x - b).norm(), 1e-12);  // condition number about 100, 16 digits
}

}  // namespace
}  // namespace nao::sim
