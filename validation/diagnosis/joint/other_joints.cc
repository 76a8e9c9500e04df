#include "validation/diagnosis/joint/other_joints.h"

#include <algorithm>
#include <cmath>

namespace nao::validation {

double OtherJoints::costOf(std::size_t cause, double x) const {
  double cost = 0;
  for (const std::vector<SharedPart>& joint : shared) {
    const SharedPart* nearest = nullptr;
    for (const SharedPart& part : joint) {
      if (part.cause != cause || part.scanned) continue;
      if (nearest == nullptr || std::abs(part.x - x) < std::abs(nearest->x - x)) nearest = &part;
    }
    if (nearest == nullptr) continue;
    const double scale = x / nearest->x;
    cost += std::max(0.0, scale * (scale * nearest->square / 2 - nearest->along));
  }
  return cost;
}

}  // namespace nao::validation
