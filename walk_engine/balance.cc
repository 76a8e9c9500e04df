#include "walk_engine/balance.h"

#include <algorithm>

namespace nao::walk {
namespace {

constexpr double kMost = 0.15;  // [rad] of correction: beyond it the foot stands on its edge anyway

}  // namespace

Balance::Balance(const RobotModel& model, const Tuning& tuning)
    : roll_damping_(tuning.roll_damping), pitch_damping_(tuning.pitch_damping) {
  for (std::size_t i = 0; i < 2; ++i) {
    const auto foot = static_cast<std::size_t>(model.feet[i].body);
    const auto ankle = static_cast<std::size_t>(model.bodies[foot].parent);
    ankle_roll_[i] = model.coordinates[foot - 1].joint;
    ankle_pitch_[i] = model.coordinates[ankle - 1].joint;
  }
}

void Balance::apply(const Vec3& gyroscope, std::array<bool, 2> stands,
                    JointArray<double>& angle) const {
  const double roll = std::clamp(roll_damping_ * gyroscope.x(), -kMost, kMost);
  const double pitch = std::clamp(pitch_damping_ * gyroscope.y(), -kMost, kMost);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!stands[i]) continue;
    angle[ankle_roll_[i]] += roll;
    angle[ankle_pitch_[i]] += pitch;
  }
}

}  // namespace nao::walk
