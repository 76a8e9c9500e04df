#pragma once

#include <vector>

#include "core/robot_io.h"
#include "core/robot_model.h"
#include "sim/tree_matrix.h"

namespace nao::sim {

/// The ideal motors of a robot, linearly implicit in the joint's angle and rate:
///   torque = kp (command - angle) - kd rate,   |torque| <= stiffness * efficiency * stall *
///                                              (1 - |rate| / no-load speed while driving)
/// Stiffness scales the torque limit, not the gains. At stiffness 0 or below a motor only holds
/// still, with 5 % of its stall torque; once moved, at stiffness 0, it also brakes like a shorted
/// one, torque = -(stall / no-load speed) rate. Deviations are effects.
class Drive {
 public:
  Drive(const RobotModel& model, int root_speeds);

  /// Rotor inertia by speed [kg m^2]; a motor that turns two hinges counts once.
  const Eigen::VectorXd& rotorInertia() const { return rotor_inertia_; }

  /// Starts a step of `h` [s] from angles `q` and rates `u`, both by coordinate.
  void prepare(const JointCommand& command, const double* q, const double* u, double h);

  /// Adds the torques and their change along the step.
  void addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) const;

  /// After a solve for the change of speeds `du`: motors beyond their limit now give just that.
  /// True if any changed, so that the step must be solved again.
  bool revise(const Eigen::VectorXd& du);

  /// Torque [N m] of each motor over the step solved last.
  const JointArray<double>& torque() const { return torque_; }

 private:
  struct Motor {
    double share = 1;     // of each hinge in the motor's torque
    double limit_up = 0;  // [N m] largest torque
    double limit_down = 0;
    double now = 0;     // [N m] at the start of the step, with the rate carried on
    double change = 0;  // [N m s/rad] its fall per unit of change of rate
    bool saturated = false;
  };
  static void prepareLimp(const Actuator& actuator, bool open, double u, Motor& motor);
  void prepareMotor(std::size_t joint, const JointCommand& command, double q, double u, double h);

  const RobotModel& model_;
  int root_speeds_;
  double h_ = 0;
  Eigen::VectorXd rotor_inertia_;
  std::vector<Motor> motors_;
  JointArray<double> torque_;
};

}  // namespace nao::sim
