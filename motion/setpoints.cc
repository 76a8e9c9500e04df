#include "motion/setpoints.h"

#include <cmath>

namespace nao::motion {

void Setpoints::set(Joint joint, double target, double speed) {
  targets_[joint] = target;
  speeds_[joint] = speed;
  active_.set(index(joint));
}

void Setpoints::advance(double dt, JointArray<double>& angle) {
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (!active_.test(i)) continue;
    const double way = targets_[i] - angle[i];
    const double step = speeds_[i] * dt;
    if (std::abs(way) <= step) {
      angle[i] = targets_[i];
      active_.reset(i);
    } else {
      angle[i] += std::copysign(step, way);
    }
  }
}

void Setpoints::archive(Archive& archive) {
  archive.value(active_);
  for (std::size_t i = 0; i < targets_.size(); ++i) {
    if (!active_.test(i)) continue;
    archive.value(targets_[i]);
    archive.value(speeds_[i]);
  }
}

}  // namespace nao::motion
