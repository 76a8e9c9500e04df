#include "sim/tree_matrix.h"

#include "core/check.h"

namespace nao::sim {

TreeMatrix::TreeMatrix(std::vector<int> parent)
    : parent_(std::move(parent)), values_(parent_.size() * parent_.size(), 0.0) {
  for (int i = 0; i < size(); ++i) NAO_CHECK(this->parent(i) < i);
}

void TreeMatrix::addDiagonal(const Eigen::VectorXd& d) {
  for (int i = 0; i < size(); ++i) at(i, i) += d[i];
}

void TreeMatrix::addOuterProduct(int leaf, const double* j, double weight) {
  for (int row = leaf; row >= 0; row = parent(row), ++j) {
    const double scaled = weight * *j;
    const double* other = j;
    for (int column = row; column >= 0; column = parent(column)) {
      at(row, column) += scaled * *other++;
    }
  }
}

void TreeMatrix::factor() {
  for (int k = size() - 1; k >= 0; --k) {
    const double inverse = 1 / at(k, k);
    for (int i = parent(k); i >= 0; i = parent(i)) {
      const double a = at(k, i) * inverse;
      for (int j = i; j >= 0; j = parent(j)) at(i, j) -= a * at(k, j);
      at(k, i) = a;
    }
  }
}

void TreeMatrix::solve(Eigen::VectorXd& x) const {
  for (int i = size() - 1; i >= 0; --i) {
    for (int j = parent(i); j >= 0; j = parent(j)) x[j] -= at(i, j) * x[i];
  }
  for (int i = 0; i < size(); ++i) x[i] /= at(i, i);
  for (int i = 0; i < size(); ++i) {
    for (int j = parent(i); j >= 0; j = parent(j)) x[i] -= at(i, j) * x[j];
  }
}

}  // namespace nao::sim
