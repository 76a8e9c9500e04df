#pragma once

#include <memory>
#include <vector>

#include "core/frames.h"
#include "core/robot_model.h"

namespace nao::sim {

/// Where a tree of bodies is and how it moves; a plain value.
///   q: root's quaternion w x y z, root's position [m] in W, then one angle [rad] per coordinate
///   u: root's angular velocity [rad/s], its velocity [m/s], both in W, then the rates [rad/s]
/// A robot with a fixed base has the coordinates alone.
struct TreeState {
  Eigen::VectorXd q;
  Eigen::VectorXd u;
};

/// Motion of every body in W, for one TreeState.
struct BodyMotion {
  Mat3 R_WB = Mat3::Identity();
  Vec3 p_WB = Vec3::Zero();  // [m] the body's origin
  Vec3 w_WB = Vec3::Zero();  // [rad/s]
  Vec3 v_WB = Vec3::Zero();  // [m/s] of the origin
};

/// The robot's tree in Simbody: the only code that knows Simbody, and the truth that every faster
/// path is held against. Built once; calc... never change the tree, only its scratch memory.
/// Hinges that share a motor move freely here: tying them together is the stepper's work.
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
