#pragma once

#include <vector>

#include <Eigen/Dense>

namespace nao::sim {

/// A symmetric positive definite matrix with the sparsity of a kinematic tree: entry (i, j) is
/// non-zero only if one of i, j is an ancestor of the other. Its factorisation L^T D L makes no
/// fill-in (Featherstone, Rigid Body Dynamics Algorithms, 2008, section 6.5). The ancestors of a
/// node are held as runs of neighbouring indices, so that inner loops walk through memory.
class TreeMatrix {
 public:
  /// `parent[i]` < i, or -1 for the root.
  explicit TreeMatrix(std::vector<int> parent);

  int size() const { return static_cast<int>(parent_.size()); }
  int parent(int i) const { return parent_[static_cast<std::size_t>(i)]; }
  /// The root, ..., i's parent, and i itself: depth(i) entries.
  const int* chain(int i) const { return chains_.data() + i * size(); }
  int depth(int i) const { return depth_[static_cast<std::size_t>(i)]; }

  /// The lower triangle: at(i, j) with j an ancestor of i, or i itself.
  double& at(int i, int j) { return row(i)[j]; }
  double at(int i, int j) const { return row(i)[j]; }
  double* row(int i) { return values_.data() + i * size(); }
  const double* row(int i) const { return values_.data() + i * size(); }

  /// Takes over the entries of a matrix of the same tree.
  void takeEntries(const TreeMatrix& other) { values_ = other.values_; }
  /// Becomes (a - b) * scale, both of the same tree.
  void takeDifference(const TreeMatrix& a, const TreeMatrix& b, double scale);
  /// Adds the entries of a matrix of the same tree.
  void add(const TreeMatrix& other);

  /// Adds the diagonal `d`.
  void addDiagonal(const Eigen::VectorXd& d);

  /// Adds weight * j j^T, where `j` holds the entries of one row from the root to `leaf`: a force
  /// along one direction on a body that hangs at `leaf`.
  void addOuterProduct(int leaf, const double* j, double weight);

  /// x += scale * j, and j . x, for such a row.
  void addScaled(int leaf, const double* j, double scale, Eigen::VectorXd& x) const;
  double dot(int leaf, const double* j, const Eigen::VectorXd& x) const;

  /// Replaces the matrix by its factors. Entries must not be read as a matrix afterwards.
  void factor();

  /// x becomes the solution of A x = b, where b is x's value before. After factor() only.
  void solve(Eigen::VectorXd& x) const;

 private:
  struct Run {  // indices first to last, both included
    int first, last;
  };
  void factorPivot(int k);

  std::vector<int> parent_;
  std::vector<int> depth_;
  std::vector<int> chains_;     // rows of size() entries
  std::vector<Run> runs_;       // of the ancestors of each node and itself, root first
  std::vector<int> first_run_;  // by node; one more at the end
  std::vector<double> values_;
  std::vector<double> inverse_;  // of D, after factor()
};

}  // namespace nao::sim
