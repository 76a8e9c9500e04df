#pragma once

#include "core/archive.h"
#include "core/joint.h"
#include "core/robot_model.h"

namespace nao::walk {

/// The joints' way into the walking pose: how far they were from it fades, by minimum jerk, as
/// slowly as the slowest of them needs.
class Rise {
 public:
  /// From angles `now` to those of the walking pose [rad]; `dt` [s] of a cycle.
  void plan(const RobotModel& model, const JointArray<double>& now,
            const JointArray<double>& walking, double dt);

  /// One cycle: what is left of the difference, on top of the walking pose's angles.
  void apply(JointArray<double>& angle);
  int left() const { return cycles_ - done_; }  // [cycles]

  void archive(Archive& archive);

 private:
  JointArray<double> offset_;  // [rad] at the start
  int cycles_ = 0;
  int done_ = 0;
};

}  // namespace nao::walk
