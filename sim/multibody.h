#pragma once

#include <memory>
#include <vector>

#include "core/robot_model.h"
#include "sim/body_motion.h"

namespace nao::sim {

/// The robot's tree in Simbody: the truth that every faster path is held against, by tests. Built
/// once; calc... never change the tree, only its scratch memory. Hinges that share a motor move
/// freely here: tying them together is the stepper's work.
class Multibody {
 public:
  /// `gravity` [m/s^2] pulls along -z of W.
  Multibody(const RobotModel& model, double gravity);
  ~Multibody();
  Multibody(const Multibody&) = delete;
  Multibody& operator=(const Multibody&) = delete;

  int speedCount() const;         // length of u
  int rootSpeedCount() const;     // 6, or 0 with a fixed base
  int rootPositionCount() const;  // 7, or 0 with a fixed base

  /// Upright above the origin, all angles 0, at rest.
  TreeState zeroState() const;

  /// Takes `state` over for the calls below.
  void setState(const TreeState& state);

  /// Poses and velocities of all bodies at the state set last.
  void calcMotion(std::vector<BodyMotion>& motion) const;

  /// The generalized forces [N m, N] that would keep u constant without gravity.
  void calcVelocityBias(Eigen::VectorXd& bias) const;

  /// Simbody's own answer: u' under gravity and the generalized forces `f`, by articulated bodies.
  /// Slow; oracle.
  Eigen::VectorXd calcAcceleration(const Eigen::VectorXd& f) const;

  /// Simbody's own mass matrix. Slow; oracle.
  Eigen::MatrixXd calcMassMatrix() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace nao::sim
