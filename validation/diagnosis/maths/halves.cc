#include "validation/diagnosis/maths/halves.h"

#include <algorithm>

namespace nao::validation {
namespace {

constexpr double kLeast = 0.6;  // of a change's squares that is no chance, at least: free choice

}  // namespace

double Halves::coherence() const {
  const double lengths = first.norm() * second.norm();
  return lengths > 0 ? first.dot(second) / lengths : 0;
}

Explained::Explained(const Halves& change, const Eigen::VectorXd& residual) {
  const Eigen::VectorXd mean = change.mean();
  along_ = mean.dot(residual);
  square_ = std::max(change.first.dot(change.second), kLeast * mean.squaredNorm());
}

}  // namespace nao::validation
