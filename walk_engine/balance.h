#pragma once

#include <array>

#include "core/frames.h"
#include "core/joint.h"
#include "core/robot_model.h"
#include "walk_engine/tuning.h"

namespace nao::walk {

/// Damps the rocking of the body on its soles: turns the ankles of the standing feet by
///   ankle += damping * torso rate,
/// for roll and for pitch, so that the pressure moves to where it brakes. Without it the landing of
/// a foot shakes a body on stiff servos a little more with every step. Immutable.
class Balance {
 public:
  Balance(const RobotModel& model, const Tuning& tuning);

  /// `gyroscope` [rad/s] in T, `stands` by Foot.
  void apply(const Vec3& gyroscope, std::array<bool, 2> stands, JointArray<double>& angle) const;

 private:
  double roll_damping_;                 // [s]
  double pitch_damping_;                // [s]
  std::array<Joint, 2> ankle_pitch_{};  // by Foot
  std::array<Joint, 2> ankle_roll_{};
};

}  // namespace nao::walk
