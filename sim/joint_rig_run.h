#pragma once

#include <Eigen/Core>

#include "sim/geared_motor.h"
#include "sim/joint_rig.h"
#include "sim/joint_stops.h"
#include "sim/motor_heat.h"

namespace nao::sim {

/// The Ornstein-Uhlenbeck torque of a run: exact at its own samples, a tenth of its correlation
/// time apart, and linear between; scaled so that its variance in the mean over time is sd^2.
class RigTorque {
 public:
  RigTorque(const RigChance& chance, double h);
  bool acts() const { return fresh_ > 0; }
  double next();

 private:
  Random random_;
  long steps_ = 1;  // from one sample to the next
  long left_ = 0;
  double keep_ = 0, fresh_ = 0;
  double torque_ = 0, change_ = 0, sample_ = 0;  // [N m]
};

/// One run of a JointRig: its state, row by row and step by step.
class JointRigRun {
 public:
  JointRigRun(const RobotModel& model, Duration step, EffectChain& effects,
              const JointOrders& orders, const JointLoad& load, const RigChance& chance);

  JointSignals all(Duration settle);

 private:
  struct Line {  // a number that changes linearly from value to value
    double now = 0, change = 0;
    /// On from this place among the values to the next, in so many steps.
    void go(const std::vector<double>& values, double place, double steps);
    void hold(const std::vector<double>& values) { now = values[0], change = 0; }
    double next() {
      const double value = now;
      now += change;
      return value;
    }
  };
  struct Other {
    const std::vector<double>* angle;
    Line line;
  };

  static BodyPlan makePlan(const RobotModel& model, EffectChain& effects);
  void steps(long count);
  void step();
  void order();
  const DriveTerms* calcTerms();
  void solve(double bias, double inertia);
  void report(JointSignals& signals);

  const Duration step_;
  const double h_;  // [s]
  EffectChain& effects_;
  const JointOrders& orders_;
  const JointLoad& load_;
  const BodyPlan plan_;
  GearedMotor motor_;
  const double rotor_;  // [kg m^2] that turns with the link
  JointStops stops_;
  double lower_, upper_;  // [rad] beyond which a stop may be near
  MotorHeat heat_;
  RigTorque torque_;
  Line inertia_, bias_, reference_, slope_;
  std::vector<Other> others_;

  SimTime now_{};
  long next_order_ = 1;  // row whose orders act next
  double until_order_;   // [steps]
  const double late_;    // [values] of the load
  double q_, u_ = 0;     // [rad], [rad/s] of the link
  JointCommand sent_, followed_;
  JointArray<double> angle_, rate_, motor_torque_, gear_torque_;
  DriveTerms terms_;
  SensorFrame frame_;
  std::vector<double> angles_, rates_;  // of all hinges
  TreeMatrix system_;
  Eigen::VectorXd du_;
};

}  // namespace nao::sim
