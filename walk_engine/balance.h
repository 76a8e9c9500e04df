#pragma once

#include <array>

#include "core/frames.h"
#include "core/joint.h"
#include "core/robot_model.h"
#include "walk_engine/tuning.h"

namespace nao::walk {

/// Damps the rocking of the body on its soles with ankles and hips. Immutable.
///   ankle += damping * torso rate          for roll and for pitch (ankle strategy): the pressure
///                                          moves to where it brakes. Without it the landing of a
///                                          foot shakes a body on stiff servos more every step
///   hip roll -= hip_follow * roll rate     (hip strategy): the torso turns with a fall to the
///                                          side, which turns the legs, and so the ground's
///                                          answer, against it
/// Each for the feet that stand. Source of the strategies: Horak and Nashner, Central programming
/// of postural movements, 1986.
class Balance {
 public:
  Balance(const RobotModel& model, const Tuning& tuning);

  /// `gyroscope` [rad/s] in T, `stands` by Foot.
  void apply(const Vec3& gyroscope, std::array<bool, 2> stands, JointArray<double>& angle) const;

 private:
  double roll_damping_;                 // [s]
  double pitch_damping_;                // [s]
  double hip_follow_;                   // [s]
  std::array<Joint, 2> ankle_pitch_{};  // by Foot
  std::array<Joint, 2> ankle_roll_{};
  std::array<Joint, 2> hip_roll_{};
};

}  // namespace nao::walk
