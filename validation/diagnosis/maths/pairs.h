#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace nao::validation {

/// What one cause does to a whitened prediction at one size, and how far that may be scaled.
struct PairPart {
  Eigen::VectorXd white;
  double lower = 0, upper = 0;  // of the scale
};

/// Two of several parts, by their places, and at which scale of each they explain most together.
struct PartPair {
  std::size_t first = 0, second = 0;
  double first_scale = 0, second_scale = 0;
  double left = 0;  // half the squares of the residual less both
};

/// Every two of the parts, best first. Parts that do nothing are in no pair.
std::vector<PartPair> pairsOf(const std::vector<PairPart>& parts, const Eigen::VectorXd& residual);

}  // namespace nao::validation
