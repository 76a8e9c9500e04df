#include "walk_engine/sway.h"

#include <algorithm>

namespace nao::walk {
namespace {

constexpr double kMost = 0.015;  // [m] more would walk like a wooden doll; free

}  // namespace

void Sway::watch(double roll, std::array<bool, 2> stands) {
  const bool single = stands[0] != stands[1];
  if (single) {
    const double outward = stands[0] ? -roll : roll;
    lean_ = single_ ? std::max(lean_, outward) : outward;
  } else if (single_) {
    const double more = tuning_.sway_gain * std::max(0.0, lean_ - tuning_.usual_lean);
    inset_ = std::min(kMost, tuning_.sway_memory * inset_ + more);
  }
  single_ = single;
}

void Sway::archive(Archive& archive) {
  archive.value(lean_);
  archive.value(single_);
  archive.value(inset_);
}

}  // namespace nao::walk
