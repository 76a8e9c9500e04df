#include "walk_engine/balance.h"

#include <algorithm>

namespace nao::walk {
namespace {

constexpr double kMost = 0.15;  // [rad] of correction: beyond it the foot stands on its edge anyway

}  // namespace

Balance::Balance(const RobotModel& model, const Tuning& tuning)
    : roll_damping_(tuning.roll_damping),
      pitch_damping_(tuning.pitch_damping),
      hip_follow_(tuning.hip_follow) {
  for (std::size_t i = 0; i < 2; ++i) {  // up the leg: ankle roll and pitch, knee, hip pitch, roll
    int body = model.feet[i].body;
    const auto next = [&] {
      const Joint joint = model.coordinates[static_cast<std::size_t>(body) - 1].joint;
      body = model.bodies[static_cast<std::size_t>(body)].parent;
      return joint;
    };
    ankle_roll_[i] = next();
    ankle_pitch_[i] = next();
    next();
    next();
    hip_roll_[i] = next();
  }
}

void Balance::apply(const Vec3& gyroscope, std::array<bool, 2> stands,
                    JointArray<double>& angle) const {
  const double roll = std::clamp(roll_damping_ * gyroscope.x(), -kMost, kMost);
  const double pitch = std::clamp(pitch_damping_ * gyroscope.y(), -kMost, kMost);
  const double hip = std::clamp(hip_follow_ * gyroscope.x(), -kMost, kMost);
  for (std::size_t i = 0; i < 2; ++i) {
    if (!stands[i]) continue;
    angle[ankle_roll_[i]] += roll;
    angle[ankle_pitch_[i]] += pitch;
    angle[hip_roll_[i]] -= hip;
  }
}

}  // namespace nao::walk
