#include "walk_engine/levelling.h"

#include <algorithm>

namespace nao::walk {
namespace {

// Zeros that are 0.3 degrees off in each of three joints add up to less in all but one leg of two
// hundred; beyond it is a push or a fall.
constexpr double kMost = 0.025;  // [rad]

}  // namespace

Levelling::Levelling(const RobotModel& model, const Tuning& tuning) : time_(tuning.level_time) {
  for (std::size_t i = 0; i < 2; ++i) {
    const auto foot = static_cast<std::size_t>(model.feet[i].body);
    const auto ankle = static_cast<std::size_t>(model.bodies[foot].parent);
    ankle_pitch_[i] = model.coordinates[ankle - 1].joint;
  }
}

void Levelling::learn(double tilt, std::array<bool, 2> stands, double dt) {
  if (time_ <= 0 || stands[0] == stands[1]) return;
  double& offset = offset_[stands[0] ? 0 : 1];
  offset = std::clamp(offset + dt / time_ * tilt, -kMost, kMost);
}

void Levelling::apply(JointArray<double>& angle) const {
  for (std::size_t i = 0; i < 2; ++i) angle[ankle_pitch_[i]] += offset_[i];
}

}  // namespace nao::walk
