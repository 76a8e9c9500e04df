#include "validation/diagnosis/rig/yielding_inertia.h"

#include <algorithm>
#include <cmath>

namespace nao::validation {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Half a window [s]: a few times as long as a jolt, shorter than a swing. Free choice.
constexpr double kReach = 0.025;
// [rad/s^2] Accelerations that say nothing: a few times those of smooth motions. Free choice.
constexpr double kQuiet = 20;

// Mean over each window of 2 reach + 1 values, fewer at the ends.
VectorXd windowMean(const VectorXd& values, Index reach) {
  VectorXd sums(values.size() + 1);
  sums[0] = 0;
  for (Index i = 0; i < values.size(); ++i) sums[i + 1] = sums[i] + values[i];
  VectorXd mean(values.size());
  for (Index i = 0; i < values.size(); ++i) {
    const Index from = std::max<Index>(0, i - reach);
    const Index to = std::min(values.size(), i + reach + 1);
    mean[i] = (sums[to] - sums[from]) / static_cast<double>(to - from);
  }
  return mean;
}

}  // namespace

void moveYieldToInertia(double dt, const VectorXd& acceleration, Eigen::Ref<VectorXd> torque,
                        Eigen::Ref<VectorXd> inertia) {
  const auto reach = static_cast<Index>(std::lround(kReach / dt));
  const VectorXd a = acceleration - windowMean(acceleration, reach);
  const VectorXd r = torque - windowMean(torque, reach);
  const VectorXd along = windowMean(r.cwiseProduct(a), reach);
  const VectorXd square = windowMean(a.cwiseAbs2(), reach);
  for (Index i = 0; i < torque.size(); ++i) {
    const double fitted = along[i] / (square[i] + kQuiet * kQuiet);
    const double yield = std::clamp(fitted, -(1 - kLeastOfInertia) * inertia[i], 0.0);
    torque[i] -= yield * acceleration[i];
    inertia[i] += yield;
  }
}

}  // namespace nao::validation
