#include "sim/tree_matrix.h"

#include "core/check.h"

namespace nao::sim {

TreeMatrix::TreeMatrix(std::vector<int> parent)
    : parent_(std::move(parent)),
      depth_(parent_.size(), 0),
      chains_(parent_.size() * parent_.size(), -1),
      values_(parent_.size() * parent_.size(), 0.0) {
  for (int i = 0; i < size(); ++i) {
    NAO_CHECK(this->parent(i) < i);
    int* chain = chains_.data() + i * size();
    for (int j = i; j >= 0; j = this->parent(j)) *chain++ = j;
    depth_[static_cast<std::size_t>(i)] = static_cast<int>(chain - (chains_.data() + i * size()));
  }
}

void TreeMatrix::addDiagonal(const Eigen::VectorXd& d) {
  for (int i = 0; i < size(); ++i) at(i, i) += d[i];
}

void TreeMatrix::addOuterProduct(int leaf, const double* j, double weight) {
  const int* nodes = chain(leaf);
  const int count = depth(leaf);
  for (int r = 0; r < count; ++r) {
    const double scaled = weight * j[r];
    double* values = row(nodes[r]);
    for (int c = r; c < count; ++c) values[nodes[c]] += scaled * j[c];
  }
}

void TreeMatrix::factor() {
  for (int k = size() - 1; k >= 0; --k) {
    double* pivot = row(k);
    const double inverse = 1 / pivot[k];
    const int* nodes = chain(k);
    const int count = depth(k);
    for (int r = 1; r < count; ++r) {
      double* values = row(nodes[r]);
      const double a = pivot[nodes[r]] * inverse;
      for (int c = r; c < count; ++c) values[nodes[c]] -= a * pivot[nodes[c]];
      pivot[nodes[r]] = a;
    }
  }
}

void TreeMatrix::solve(Eigen::VectorXd& x) const {
  for (int i = size() - 1; i >= 0; --i) {
    const int* nodes = chain(i);
    for (int c = 1; c < depth(i); ++c) x[nodes[c]] -= row(i)[nodes[c]] * x[i];
  }
  for (int i = 0; i < size(); ++i) x[i] /= at(i, i);
  for (int i = 0; i < size(); ++i) {
    const int* nodes = chain(i);
    double sum = x[i];
    for (int c = 1; c < depth(i); ++c) sum -= row(i)[nodes[c]] * x[nodes[c]];
    x[i] = sum;
  }
}

}  // namespace nao::sim
