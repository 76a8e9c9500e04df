#pragma once

#include <vector>

#include <Eigen/Dense>

namespace nao::sim {

/// A symmetric positive definite matrix with the sparsity of a kinematic tree: entry (i, j) is
/// non-zero only if one of i, j is an ancestor of the other. Its factorisation L^T D L makes no
/// fill-in (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 6.5).
class TreeMatrix {
 public:
  /// `parent[i]` < i, or -1 for the root.
  explicit TreeMatrix(std::vector<int> parent);

  int size() const { return static_cast<int>(parent_.size()); }
  int parent(int i) const { return parent_[static_cast<std::size_t>(i)]; }
  /// i itself, its parent, and so on up to the root; depth(i) entries.
  const int* chain(int i) const { return chains_.data() + i * size(); }
  int depth(int i) const { return depth_[static_cast<std::size_t>(i)]; }

  /// The lower triangle: at(i, j) with j an ancestor of i, or i itself.
  double& at(int i, int j) { return values_[static_cast<std::size_t>(i * size() + j)]; }
  double at(int i, int j) const { return values_[static_cast<std::size_t>(i * size() + j)]; }

  /// Adds the diagonal `d`.
  void addDiagonal(const Eigen::VectorXd& d);

  /// Adds weight * j j^T, where `j` holds the non-zero entries of one row from `leaf` up to the
  /// root, in that order: a force along one direction on a body that hangs at `leaf`.
  void addOuterProduct(int leaf, const double* j, double weight);

  /// Replaces the matrix by its factors. Entries must not be read as a matrix afterwards.
  void factor();

  /// x becomes the solution of A x = b, where b is x's value before. After factor() only.
  void solve(Eigen::VectorXd& x) const;

 private:
  double* row(int i) { return values_.data() + i * size(); }
  const double* row(int i) const { return values_.data() + i * size(); }

  std::vector<int> parent_;
  std::vector<int> depth_;
  std::vector<int> chains_;  // rows of size() entries
  std::vector<double> values_;
};

}  // namespace nao::sim
