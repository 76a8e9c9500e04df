#include "sim/tree_matrix.h"

#include <algorithm>

#include "core/check.h"

namespace nao::sim {

TreeMatrix::TreeMatrix(std::vector<int> parent)
    : parent_(std::move(parent)),
      depth_(parent_.size(), 0),
      chains_(parent_.size() * parent_.size(), -1),
      values_(parent_.size() * parent_.size(), 0.0),
      inverse_(parent_.size(), 0.0) {
  for (int i = 0; i < size(); ++i) {
    NAO_CHECK(this->parent(i) < i);
    int* chain = chains_.data() + i * size();
    int count = 0;
    for (int j = i; j >= 0; j = this->parent(j)) chain[count++] = j;
    std::reverse(chain, chain + count);
    depth_[static_cast<std::size_t>(i)] = count;
    first_run_.push_back(static_cast<int>(runs_.size()));
    for (int c = 0; c < count; ++c) {
      if (c > 0 && chain[c] == runs_.back().last + 1) {
        ++runs_.back().last;
      } else {
        runs_.push_back({chain[c], chain[c]});
      }
    }
  }
  first_run_.push_back(static_cast<int>(runs_.size()));
}

void TreeMatrix::takeDifference(const TreeMatrix& a, const TreeMatrix& b, double scale) {
  for (std::size_t i = 0; i < values_.size(); ++i) {
    values_[i] = (a.values_[i] - b.values_[i]) * scale;
  }
}

void TreeMatrix::add(const TreeMatrix& other) {
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] += other.values_[i];
}

void TreeMatrix::addDiagonal(const Eigen::VectorXd& d) {
  for (int i = 0; i < size(); ++i) at(i, i) += d[i];
}

void TreeMatrix::addOuterProduct(int leaf, const double* j, double weight) {
  if (leaf < 0) return;  // of a body that is bolted down
  const int* nodes = chain(leaf);
  const int count = depth(leaf);
  for (int r = 0; r < count; ++r) {
    const double scaled = weight * j[r];
    double* values = row(nodes[r]);
    const double* factors = j;
    for (int k = first_run_[static_cast<std::size_t>(nodes[r])];
         k < first_run_[static_cast<std::size_t>(nodes[r]) + 1]; ++k) {
      const Run run = runs_[static_cast<std::size_t>(k)];
      for (int c = run.first; c <= run.last; ++c) values[c] += scaled * *factors++;
    }
  }
}

void TreeMatrix::addScaled(int leaf, const double* j, double scale, Eigen::VectorXd& x) const {
  if (leaf < 0) return;
  const int* nodes = chain(leaf);
  for (int c = 0; c < depth(leaf); ++c) x[nodes[c]] += scale * j[c];
}

double TreeMatrix::dot(int leaf, const double* j, const Eigen::VectorXd& x) const {
  if (leaf < 0) return 0;
  const int* nodes = chain(leaf);
  double sum = 0;
  for (int c = 0; c < depth(leaf); ++c) sum += j[c] * x[nodes[c]];
  return sum;
}

void TreeMatrix::factor() {
  for (int k = size() - 1; k >= 0; --k) factorPivot(k);
}

// Takes node k out: what its ancestors have to do with each other through it.
void TreeMatrix::factorPivot(int k) {
  double* pivot = row(k);
  const double inverse = 1 / pivot[k];
  inverse_[static_cast<std::size_t>(k)] = inverse;
  const int* nodes = chain(k);
  for (int r = depth(k) - 2; r >= 0; --r) {
    const int node = nodes[r];
    double* values = row(node);
    const double a = pivot[node] * inverse;
    for (int i = first_run_[static_cast<std::size_t>(node)];
         i < first_run_[static_cast<std::size_t>(node) + 1]; ++i) {
      const Run run = runs_[static_cast<std::size_t>(i)];
      for (int c = run.first; c <= run.last; ++c) values[c] -= a * pivot[c];
    }
    pivot[node] = a;
  }
}

void TreeMatrix::solve(Eigen::VectorXd& x) const {
  for (int i = size() - 1; i >= 0; --i) {
    const int* nodes = chain(i);
    const double* factors = row(i);
    const double xi = x[i];
    for (int c = 0; c < depth(i) - 1; ++c) x[nodes[c]] -= factors[nodes[c]] * xi;
  }
  for (int i = 0; i < size(); ++i) {
    const int* nodes = chain(i);
    const double* factors = row(i);
    double sum = x[i] * inverse_[static_cast<std::size_t>(i)];
    for (int c = 0; c < depth(i) - 1; ++c) sum -= factors[nodes[c]] * x[nodes[c]];
    x[i] = sum;
  }
}

}  // namespace nao::sim
