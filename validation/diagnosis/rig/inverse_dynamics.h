#pragma once

#include <vector>

#include <Eigen/Core>

#include "sim/body_plan.h"
#include "sim/effects/catalogue.h"
#include "sim/tree_dynamics.h"

namespace nao::validation {

/// The robot as these effects build it, in a World of standard gravity.
sim::BodyPlan planOf(const RobotModel& model, const std::vector<EffectSetting>& effects,
                     const sim::EffectCatalogue& catalogue);

/// How much later than it was measured each joint's angle is reported [s], by these effects.
std::vector<double> reportDelays(const RobotModel& model, const std::vector<EffectSetting>& effects,
                                 const sim::EffectCatalogue& catalogue);

/// What a motion of a robot with a fixed base asks of its motors, rotors left out. The hinges of a
/// motor turn as one. `plan` must outlive it.
class InverseDynamics {
 public:
  explicit InverseDynamics(const sim::BodyPlan& plan);

  /// Takes angles and rates by coordinate.
  void move(const Eigen::VectorXd& q, const Eigen::VectorXd& u);

  /// [N m] by coordinate, for these accelerations.
  Eigen::VectorXd torque(const Eigen::VectorXd& acceleration) const;
  /// [N m] by coordinate, without any.
  const Eigen::VectorXd& bias() const { return bias_; }

  /// [kg m^2] that this joint's motor moves.
  double inertia(Joint joint) const;
  /// The part of a torque by coordinate that this joint's motor bears.
  double share(Joint joint, const Eigen::VectorXd& torque) const;

  /// [N m/rad] by which the bias of this joint grows with its own angle. The state set before is
  /// gone after this.
  double slope(Joint joint, const Eigen::VectorXd& q, const Eigen::VectorXd& u);

 private:
  const std::vector<int>& hinges(Joint joint) const {
    return plan_.model.actuators[index(joint)].coordinates;
  }
  double biasBeside(Joint joint, Eigen::VectorXd q, const Eigen::VectorXd& u, double angle);
  bool related(int leaf, int other) const;

  const sim::BodyPlan& plan_;
  sim::TreeDynamics dynamics_;
  sim::TreeMatrix inertia_;
  Eigen::VectorXd bias_;
};

}  // namespace nao::validation
