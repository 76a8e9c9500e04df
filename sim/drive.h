#pragma once

#include <vector>

#include "core/robot_io.h"
#include "sim/body_plan.h"
#include "sim/effects/effect.h"
#include "sim/geared_motor.h"
#include "sim/tree_matrix.h"

namespace nao::sim {

/// The motors of a robot between its command and its tree; the law stands in geared_motor.h. A
/// motor of stiffness below 0 does not even brake if all motors of its board are below 0.
class Drive {
 public:
  Drive(const BodyPlan& plan, int root_speeds);

  /// Rotor inertia that moves rigidly with the speeds of the tree [kg m^2]; that of a motor with
  /// two hinges counts once.
  const Eigen::VectorXd& rotorInertia() const { return rotor_inertia_; }

  /// All rotors at rest where their joints are.
  void reset(const double* q);

  /// Takes over angles `q` [rad] and rates `u` [rad/s] by coordinate, so that angle() and rate()
  /// are of now. To be called whenever the tree has moved.
  void observe(const double* q, const double* u);

  const JointArray<double>& angle() const { return angle_; }    // [rad] as motor encoders report
  const JointArray<double>& rate() const { return rate_; }      // [rad/s] of the rotors
  const JointArray<double>& torque() const { return torque_; }  // [N m] of the motors, last step
  const JointArray<double>& load() const { return load_; }      // [N m] through the gears

  /// Whose servo was held at its limit in the last step.
  JointArray<bool> saturated() const;

  /// Starts a step of `h` [s]. `terms` null: no effect acts on the drives.
  void prepare(const JointCommand& command, const double* q, const double* u, double h,
               const DriveTerms* terms);

  /// Adds the torques at this very state, without a step, friction or play.
  void addSmooth(const JointCommand& command, const double* q, const double* u,
                 Eigen::VectorXd& torque);

  /// Adds the torques and their change along the step.
  void addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) const;

  /// After a solve for the change of speeds `du`: true if a motor changed its mind: solve again.
  bool revise(const Eigen::VectorXd& du);

  /// Ends the step.
  void finish(const Eigen::VectorXd& du);

  void archive(Archive& archive);

 private:
  struct Place {  // of a motor with hinges
    std::size_t joint;
    int coordinate;           // of its first hinge
    std::vector<int> speeds;  // in u, of all its hinges
    double share;             // of each hinge in the torque
    int board;
  };
  bool boardIsOff(const JointCommand& command, const Place& place) const;

  int root_speeds_;
  double h_ = 0;
  std::vector<Place> places_;
  std::vector<GearedMotor> motors_;  // by place
  Eigen::VectorXd rotor_inertia_;
  JointArray<double> angle_, rate_, torque_, load_;
};

}  // namespace nao::sim
