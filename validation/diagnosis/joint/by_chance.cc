#include "validation/diagnosis/joint/by_chance.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "validation/diagnosis/joint/stage.h"

namespace nao::validation {

ByChance chanceOf(const Stage& stage, double critical) {
  std::vector<double> left;
  for (const Eigen::VectorXd& null : stage.nulls()) {
    left.push_back(stage.white(null).squaredNorm() / 2);
  }
  const double sum = std::accumulate(left.begin(), left.end(), 0.0);
  return {critical, sum / std::max(1.0, static_cast<double>(left.size())), quantile(left, 0.9)};
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  const double place = q * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
}

}  // namespace nao::validation
