#pragma once

#include <vector>

#include "motion/timeline/lint.h"
#include "sim/world.h"

namespace nao::validation {

/// Finds in the world, step by step, what a motion should not do to its robot, the world's first:
///   fall        the torso tilts by more than 60 degrees after it had been upright
///   torque      a servo is held at its limit for a whole cycle of the robot
///   collision   two of its bodies push each other
class PlayFaults {
 public:
  explicit PlayFaults(const RobotModel& model);

  /// After every step; `time` [s] since the motion began.
  void look(const sim::World& world, double time);

  bool fell() const { return fell_; }
  bool upright() const { return upright_; }
  double tilt() const { return tilt_; }  // [rad] of the torso

  std::vector<motion::MotionFault> take() { return log_.take(); }

 private:
  void lookAtPosture(const Pose& X_WT, double time);
  void lookAtMotors(const sim::World& world, double time);
  void lookAtContacts(const sim::World& world, double time);

  const RobotModel& model_;
  motion::FaultLog log_;
  JointArray<int> saturated_steps_;  // without a pause
  bool upright_ = false;
  bool fell_ = false;
  double tilt_ = 0;
};

}  // namespace nao::validation
