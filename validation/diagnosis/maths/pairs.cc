#include "validation/diagnosis/maths/pairs.h"

#include <Eigen/QR>
#include <algorithm>

namespace nao::validation {
namespace {

constexpr int kRounds = 10;

// Within bounds the least is found by moving along one axis, then the other, from where it would be
// without.
PartPair best(const std::vector<PairPart>& parts, std::size_t first, std::size_t second,
              const Eigen::VectorXd& residual) {
  const PairPart &one = parts[first], &two = parts[second];
  const double both = one.white.dot(two.white);
  const Eigen::Vector2d square(one.white.squaredNorm(), two.white.squaredNorm());
  const Eigen::Vector2d along(one.white.dot(residual), two.white.dot(residual));
  Eigen::Matrix2d square_of_both;
  square_of_both << square[0], both, both, square[1];
  PartPair pair{first, second, 0, 0, 0};
  pair.second_scale = square_of_both.colPivHouseholderQr().solve(along)[1];
  pair.second_scale = std::clamp(pair.second_scale, two.lower, two.upper);
  for (int round = 0; round < kRounds; ++round) {
    pair.first_scale =
        std::clamp((along[0] - pair.second_scale * both) / square[0], one.lower, one.upper);
    pair.second_scale =
        std::clamp((along[1] - pair.first_scale * both) / square[1], two.lower, two.upper);
  }
  const Eigen::VectorXd left =
      residual - pair.first_scale * one.white - pair.second_scale * two.white;
  pair.left = left.squaredNorm() / 2;
  return pair;
}

}  // namespace

std::vector<PartPair> pairsOf(const std::vector<PairPart>& parts, const Eigen::VectorXd& residual) {
  std::vector<PartPair> pairs;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].white.squaredNorm() <= 0) continue;
    for (std::size_t j = i + 1; j < parts.size(); ++j) {
      if (parts[j].white.squaredNorm() > 0) pairs.push_back(best(parts, i, j, residual));
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const PartPair& a, const PartPair& b) { return a.left < b.left; });
  return pairs;
}

}  // namespace nao::validation
