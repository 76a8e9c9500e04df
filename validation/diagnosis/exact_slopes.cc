#include "validation/diagnosis/exact_slopes.h"

#include <algorithm>
#include <cmath>

namespace nao::validation {
namespace {

constexpr double kPart = 0.08;  // of a number: free choice

// What to go to either side, within bounds; nothing if one of them is that near.
double widthOf(const FreeNumber& number, double x) {
  const double wished = std::max(number.smallest, kPart * std::abs(x));
  return std::min({wished, number.upper - x, x - number.lower});
}

}  // namespace

void setExactSlopes(Ensemble& ensemble, const std::vector<Cause>& causes, int runs, ModelFit& fit) {
  Eigen::Index column = 0;
  for (Chosen& one : fit.model) {
    const Cause& cause = causes[one.cause];
    for (std::size_t i = 0; i < one.x.size(); ++i, ++column) {
      if (i == 0 && cause.beats) continue;
      const double x = one.x[i], width = widthOf(cause.free[i], x);
      if (width <= 0) continue;
      one.x[i] = x + width;
      const Eigen::VectorXd above = ensemble.pool(settingsOf(causes, fit.model), runs).mean;
      one.x[i] = x - width;
      const Eigen::VectorXd below = ensemble.pool(settingsOf(causes, fit.model), runs).mean;
      one.x[i] = x;
      fit.jacobian.col(column) = (above - below) / (2 * width);
    }
  }
}

}  // namespace nao::validation
