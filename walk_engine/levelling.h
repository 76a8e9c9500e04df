#pragma once

#include <array>

#include "core/archive.h"
#include "core/joint.h"
#include "core/robot_io.h"
#include "core/robot_model.h"
#include "walk_engine/tuning.h"

namespace nao::walk {

/// Learns by how much each sole is out of level. A leg whose joints' zeros are off stands on toe or
/// heel, leans the body and turns it a little with every step. While one foot alone carries the
/// robot, the torso's measured pitch differs from the planned one by just that, so
///   d offset / dt = (measured - planned) / level_time
/// is added to that foot's ankle pitch. What a foot has learned it keeps. Roll is left alone: the
/// hips sag towards the swinging leg, which no ankle should answer for.
class Levelling {
 public:
  Levelling(const RobotModel& model, const Tuning& tuning);

  /// One cycle of `dt` [s]. `tilt` [rad]: pitch of the torso, measured less planned; `stands` by
  /// Foot.
  void learn(double tilt, std::array<bool, 2> stands, double dt);

  /// Adds to the ankles what has been learned.
  void apply(JointArray<double>& angle) const;

  /// What has been learned of a sole [rad].
  double offset(Foot foot) const { return offset_[index(foot)]; }

  void archive(Archive& archive) { archive.value(offset_); }

 private:
  double time_;                         // [s]
  std::array<Joint, 2> ankle_pitch_{};  // by Foot
  std::array<double, 2> offset_{};      // [rad] by Foot
};

}  // namespace nao::walk
