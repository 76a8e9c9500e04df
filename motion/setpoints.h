#pragma once

#include "core/archive.h"
#include "core/joint.h"
#include "motion/joint_set.h"

namespace nao::motion {

/// Targets that joints approach at a constant speed, booking nothing (setAngles). A target is
/// forgotten once reached, or when something else takes its joint over.
class Setpoints {
 public:
  explicit Setpoints(std::size_t joints) : targets_(joints), speeds_(joints) {}

  /// `target` [rad], `speed` [rad/s], positive.
  void set(Joint joint, double target, double speed);
  void clear(const JointSet& joints) { active_ &= ~joints; }

  const JointSet& active() const { return active_; }

  /// One cycle of `dt` [s]: moves the angles towards their targets.
  void advance(double dt, JointArray<double>& angle);

  /// Lists the targets that are still approached.
  void archive(Archive& archive);

 private:
  JointArray<double> targets_;
  JointArray<double> speeds_;
  JointSet active_;
};

}  // namespace nao::motion
