#pragma once

#include <array>

#include "core/archive.h"
#include "motion/joint_set.h"
#include "motion/motion_request.h"
#include "motion/phase.h"

namespace nao::motion {

/// A configuration within what NaoQi allows, the amplitude held to what the frequency bears.
SetBreath clipToStable(const SetBreath& config);

/// What joints do that nobody commands: nothing, return to the pose they had when told to, or
/// breathe. Head, left arm, right arm and both legs each breathe together, and only while the
/// robot stands, awake. Breathing is an offset on the command: whoever takes a joint gets it where
/// it then is; the others of that group come to rest, and all begin softly again.
///   offset = w A a_j (1 - cos(2 pi bpm / 60 t)) / 2
/// w: 0 to 1 within a second. a_j: table in idle.cc. A = 1 + amplitude, that of bpm 5 being 1 at
/// most, that of bpm 30 being 0, linear in between (NAOqi 2.1 documentation, idle).
class Idle {
 public:
  explicit Idle(const RobotModel& model);

  /// `body` tells the pose to return to.
  void set(const SetIdle& request, const Body& body);
  void configure(const SetBreath& config) { config_ = clipToStable(config); }

  /// One cycle of `dt` [s]; `held`: joints that something else moves, or that are limp.
  void update(double dt, const JointSet& held, Body& body);

  void archive(Archive& archive);

 private:
  struct Group {
    JointSet joints;
    double weight = 0;
  };
  static bool stands(const Body& body);
  void breathe(double dt, const JointSet& held, bool standing, Group& group, Body& body);
  void giveBack(double dt, const JointSet& free, Body& body) const;

  JointArray<double> swing_;  // [rad] a_j
  std::array<Group, 4> groups_;
  JointSet breath_;
  JointSet posture_;
  JointArray<double> reference_;  // [rad]
  JointArray<double> offset_;     // [rad] now in the command
  SetBreath config_;
  double phase_ = 0;  // [rad]
};

}  // namespace nao::motion
