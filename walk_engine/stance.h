#pragma once

#include <array>
#include <memory>

#include "core/archive.h"
#include "core/frames.h"
#include "core/joint.h"
#include "core/robot_model.h"
#include "motion/kinematics.h"
#include "motion/leg_ik.h"

namespace nao::walk {

/// What the body shall do: soles and centre of mass in a frame O whose floor is z = 0.
struct StanceDemand {
  std::array<Pose, 2> X_OS;  // by Foot
  Vec3 com = Vec3::Zero();   // [m] of the whole robot
  double roll = 0;           // [rad] of the torso
  double pitch = 0;          // [rad]
};

/// Leg angles for a demanded stance. The torso's place follows from the centre of mass of the whole
/// robot, arms and head included, by a few fixed-point steps; its heading is the one at which both
/// legs ask the shared yaw-pitch motor for the same angle, so nothing is lost to it.
class StanceSolver {
 public:
  explicit StanceSolver(std::shared_ptr<const RobotModel> model);

  /// Overwrites the legs' entries of `angle`, whose other entries say where arms and head are.
  /// False if a leg can not reach its place; it is then as near as it gets.
  bool solve(const StanceDemand& demand, JointArray<double>& angle);

  /// Where the last solve() has the torso, and the bodies in it.
  const Pose& torso() const { return X_OT_; }
  const motion::Kinematics& body() const { return kinematics_; }

  /// Height of the centre of mass over the floor [m] when the hips are lowered by `knee_bend` of
  /// the leg's length from straight, feet side by side, the torso pitched.
  double calcComHeight(double knee_bend, double pitch, JointArray<double> angle);

  /// Soles in R by the angles of the joints, R between them.
  std::array<Pose, 2> calcSoles(const JointArray<double>& angle);

  /// Lists from where the next solve() starts.
  void archive(Archive& archive);

 private:
  motion::LegIk ik_;
  motion::Kinematics kinematics_;
  double torso_to_sole_ = 0;  // [m] legs straight
  Pose X_OT_ = Pose::Identity();
  double yaw_ = 0;              // [rad] torso in O, found last
  Vec3 p_TCom_ = Vec3::Zero();  // [m] found last
};

}  // namespace nao::walk
