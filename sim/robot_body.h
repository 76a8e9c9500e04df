#pragma once

#include <memory>
#include <vector>

#include "core/archive.h"
#include "core/robot_io.h"
#include "sim/body_plan.h"
#include "sim/drive.h"
#include "sim/external_force.h"
#include "sim/ground_contact.h"
#include "sim/hinge_ties.h"
#include "sim/inertia_course.h"
#include "sim/integrator.h"
#include "sim/joint_stops.h"
#include "sim/mode.h"
#include "sim/phase.h"
#include "sim/tree_dynamics.h"

namespace nao::sim {

/// One robot's physics. A step is linearly implicit Euler in all that is stiff (motors, rotor
/// inertia, friction, joint stops, ground), the rest explicit:
///   (M + J_rotor + h D + h^2 K) du = h (f(q + h u, u) - bias(q, u)),   q += h (u + du)
/// Limits (torque, pull, friction) are found by solving again with what exceeds them held at its
/// limit. Hinges that share a motor are tied exactly by one more solve with the same factors.
/// In the modes Rk4 and Reference the forces are smooth functions of the state; see SmoothForces.
class RobotBody {
 public:
  explicit RobotBody(BodyPlan plan, Mode mode = Mode::Implicit);

  /// From now on `watch`, which must outlive the body, is told of the phases of each step.
  void setWatch(const PhaseWatch* watch) { watch_ = watch; }

  /// From now on inertia and bias are calculated every so many steps (InertiaCourse); motion() is
  /// of the last of these. For robots with a fixed base that can touch nothing, implicit mode.
  void setInertiaEvery(int steps);

  const RobotModel& model() const { return plan_->model; }
  const BodyPlan& plan() const { return *plan_; }

  const TreeState& tree() const { return tree_; }
  /// Moves the tree as it is; rotors and anchors start afresh.
  void setTree(TreeState tree);

  /// At rest with these angles at its encoders, soles level (or else the root upright), lowest
  /// point of the robot on the ground.
  void place(const Pose2& pose, const JointArray<double>& angles);

  /// Lets `command` act for `h` [s]. `terms` null: no effect acts on the drives.
  void step(const JointCommand& command, const DriveTerms* terms,
            const std::vector<ExternalForce>& external, double h);

  /// Where the bodies are now, in W.
  const std::vector<BodyMotion>& motion() const { return dynamics_.motion(); }
  const Drive& drive() const { return drive_; }
  /// What a joint's encoder reports, on the motor's side of the gear [rad]; hands 0..1.
  double angle(Joint joint) const;
  const std::vector<GroundContact::Force>& groundForces() const { return contact_.forces(); }
  void setWet(const std::vector<WetPatch>& patches) { contact_.setWet(patches); }
  /// Height [m] of the robot's lowest point.
  double lowestPoint() const { return contact_.lowestPoint(motion()); }

  /// Adds to `push`, by speed of the tree, what an impulse `j_W` [N s] at a point of a body is to
  /// it; respond() makes of that the change of u, with limp joints.
  void addPush(int body, const Vec3& p_W, const Vec3& j_W, Eigen::VectorXd& push) const;
  void respond(Eigen::VectorXd& push);

  /// u' under these forces, as the modes Rk4 and Reference see it.
  Eigen::VectorXd calcAcceleration(const JointCommand& command,
                                   const std::vector<ExternalForce>& external);

  /// False once a number is no longer finite: the world must stop.
  bool finite() const { return tree_.q.allFinite() && tree_.u.allFinite(); }

  void archive(Archive& archive);

 private:
  void stepSmoothly(const JointCommand& command, const std::vector<ExternalForce>& external,
                    double h);
  void solve(const std::vector<ExternalForce>& external, double h);
  void addExternal(const std::vector<ExternalForce>& external, double h);
  void tieSharedHinges(double h);
  void integrate(double h);
  void moveHands(const JointCommand& command, double h);
  void moved();
  void needInertia();
  void followInertia();
  void needMobility();
  Eigen::Quaterniond levelSoles() const;
  const double* coordinates() const { return tree_.q.data() + dynamics_.rootPositionCount(); }
  const double* rates() const { return tree_.u.data() + dynamics_.rootSpeedCount(); }

  void ended(Phase phase) const {
    if (watch_) (*watch_)(phase);
  }

  static constexpr int kMaxSolves = 6;

  std::unique_ptr<const BodyPlan> plan_;  // others keep references to its model
  TreeDynamics dynamics_;
  Drive drive_;
  JointStops stops_;
  GroundContact contact_;
  HingeTies ties_;
  SmoothForces smooth_;
  std::unique_ptr<Integrator> integrator_;  // null in the implicit mode
  TreeState tree_;
  JointArray<double> hands_;  // 0..1, for motors without a hinge
  TreeMatrix inertia_, system_, mobility_;
  InertiaCourse course_;
  bool inertia_known_ = false;  // of the present tree
  bool mobility_known_ = false;
  Eigen::VectorXd bias_, external_, du_;
  const PhaseWatch* watch_ = nullptr;
};

}  // namespace nao::sim
