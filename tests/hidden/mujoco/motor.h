#pragma once

#include <deque>

#include "core/random.h"
#include "tests/hidden/mujoco/mujoco_robot.h"

namespace nao::hidden {

/// What MuJoCo does not simulate of a motor: orders on their way, the servo, the random torque on
/// the link and what the encoder reports. Written for the second reality alone.
///   servo     a P gain on the encoder's error and a D gain on its speed, held over a step, at most
///             what the motor gives at that speed: strength (1 - speed / top speed) while driving
///   encoder   on the rotor's side of the gear
class MujocoMotor {
 public:
  MujocoMotor(const MujocoJoint& joint, double step, Random random);

  /// At rest at this angle for longer than anything is late.
  void reset(double angle);
  /// An order [rad] that was just sent.
  void order(double angle) { ordered_ = angle; }

  struct Torques {
    double rotor = 0, link = 0;  // [N m]
  };
  /// Once per step, before all else: where the rotor is now.
  void observe(double rotor);
  /// For the step that begins.
  Torques step(double speed, double link);
  /// [rad] What is read now.
  double report() const;

 private:
  static double late(const std::deque<double>& line, double steps);

  MujocoJoint joint_;
  double h_;
  double keep_ = 0, fresh_ = 0;  // of the random torque over a step
  Random random_;
  double ordered_ = 0, followed_ = 0, noise_ = 0;
  std::deque<double> orders_, readings_;  // by step, newest first
};

}  // namespace nao::hidden
