#include "tests/hidden/scaling.h"

#include <algorithm>
#include <cmath>

namespace nao::hidden {
namespace {

constexpr int kMostScalings = 8;
constexpr double kCloseEnough = 0.2;  // of the wished size
constexpr double kGrowth = 3;         // of a deviation in one scaling

}  // namespace

Scaled scaleTo(const Wish& wish, const std::function<double(double)>& sizeOf) {
  const Hideout& hideout = wish.hideout;
  const double least = std::max(hideout.least, 1e-9), most = std::abs(hideout.most);
  Scaled scaled{std::abs(hideout.start), 0};
  double below = 0, above = 0;  // deviations that were too small and too large
  for (int i = 0; i < kMostScalings; ++i) {
    scaled.deviation = std::clamp(scaled.deviation, least, most);
    scaled.size = sizeOf(scaled.deviation);
    const double ratio = wish.size / std::max(scaled.size, 1e-3);
    if (std::abs(ratio - 1) < kCloseEnough) break;
    if ((scaled.deviation >= most && ratio > 1) || (scaled.deviation <= least && ratio < 1)) break;
    (ratio > 1 ? below : above) = scaled.deviation;
    if (i + 1 == kMostScalings) break;
    const bool between = below > 0 && above > 0;
    scaled.deviation = between ? std::sqrt(below * above)
                               : scaled.deviation * std::clamp(ratio, 1 / kGrowth, kGrowth);
  }
  return scaled;
}

}  // namespace nao::hidden
