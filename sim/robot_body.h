#pragma once

#include <memory>
#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "core/world_model.h"
#include "sim/drive.h"
#include "sim/ground_contact.h"
#include "sim/joint_stops.h"
#include "sim/multibody.h"
#include "sim/tree_dynamics.h"

namespace nao::sim {

/// A force of something outside on a robot's body during one step.
struct ExternalForce {
  int body = 0;
  Vec3 p_W = Vec3::Zero();  // [m] where it acts
  Vec3 f_W = Vec3::Zero();  // [N]
};

/// One robot's physics. A step is linearly implicit Euler in all that is stiff (motors, rotor
/// inertia, joint stops, ground), the rest explicit:
///   (M + J_rotor + h D + h^2 K) du = h (f(q + h u, u) - bias(q, u)),   q += h (u + du)
/// Limits (torque, pull, friction) are found by solving again with what exceeds them held at its
/// limit. Hinges that share a motor are tied exactly by one more solve with the same factors.
class RobotBody {
 public:
  RobotBody(std::shared_ptr<const RobotModel> model, const WorldModel& world);

  const RobotModel& model() const { return *model_; }

  /// All that moves; with the anchors inside, a value from which the motion goes on bit by bit.
  struct State {
    TreeState tree;
    std::vector<GroundContact::Anchor> anchors;
    JointArray<double> hands;  // 0..1, for motors without a hinge
  };
  const State& state() const { return state_; }
  void setState(State state);

  /// At rest with these joint angles, soles level (or else the root upright), lowest point of the
  /// robot on the ground.
  void place(const Pose2& pose, const JointArray<double>& angles);

  /// Lets `command` act for `h` [s].
  void step(const JointCommand& command, const std::vector<ExternalForce>& external, double h);

  /// Where the bodies are now, in W.
  const std::vector<BodyMotion>& motion() const { return motion_; }
  /// Angle of a joint [rad]; hands 0..1.
  double angle(Joint joint) const;
  double rate(Joint joint) const;  // [rad/s]
  /// Torque of each motor over the last step [N m].
  const JointArray<double>& torque() const { return drive_.torque(); }
  const std::vector<GroundContact::Force>& groundForces() const { return contact_.forces(); }
  int solves() const { return solves_; }  // of the last step

  /// False once a number is no longer finite: the world must stop.
  bool finite() const;

 private:
  void solve(const std::vector<ExternalForce>& external, double h);
  void addExternal(const std::vector<ExternalForce>& external, double h);
  void tieSharedHinges(double h);
  void integrate(double h);
  void moveHands(const JointCommand& command, double h);
  void updateMotion();
  Eigen::Quaterniond levelSoles() const;
  const double* coordinates() const;
  const double* rates() const;

  static constexpr int kMaxSolves = 6;

  std::shared_ptr<const RobotModel> model_;
  double gravity_;  // [m/s^2]
  Multibody multibody_;
  TreeDynamics mass_;
  Drive drive_;
  JointStops stops_;
  GroundContact contact_;
  State state_;
  std::vector<BodyMotion> motion_;
  TreeMatrix inertia_, system_;
  Eigen::VectorXd bias_, external_, du_, tie_;
  int solves_ = 0;
};

}  // namespace nao::sim
