#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "core/robot_model.h"
#include "sim/effects/catalogue.h"
#include "validation/diagnosis/ensemble/joint_simulator.h"

namespace nao::validation {

/// A simulated joint that is led by a stiff spring and damper beside the course that it takes by
/// itself, and what these have to do: the torque that the model lacks there. Two effects like
/// others, of one run each, first watch(), then lead(); the object must outlive the runs, which are
/// of the same steps.
class LedJoint {
 public:
  /// `off` [rad] per row, rows `row` seconds apart: how far beside its own course it is led, of
  /// which the encoder reads `misread` [rad] too much; the first are held for `settle` seconds
  /// before; smoothed here. `inertia` [kg m^2] of what is led, `motor` what drives it.
  LedJoint(const Eigen::VectorXd& off, const Eigen::VectorXd& misread, double row, double settle,
           double inertia, const Actuator& motor);
  LedJoint(const LedJoint&) = delete;
  LedJoint& operator=(const LedJoint&) = delete;

  static constexpr char kName[] = "led_joint";
  /// The catalogue with an effect that takes down the joint's own course.
  sim::EffectCatalogue watch(sim::EffectCatalogue catalogue);
  /// The catalogue with an effect that leads it.
  sim::EffectCatalogue lead(sim::EffectCatalogue catalogue);
  /// Means over every row of time, and the own course's angle at each row.
  LedRun found() const;

 private:
  class Watch;
  class Lead;
  bool isAtItsLimit(double error, double rate) const;

  Eigen::VectorXd off_, rate_off_, misread_;
  double row_, settle_;
  Actuator motor_;
  double stiffness_, damping_;                  // [N m/rad], [N m s/rad]
  std::vector<std::pair<double, double>> own_;  // angle [rad] and rate [rad/s] of every step
  LedRun sum_;
  Eigen::VectorXd steps_;  // of every row
};

/// An angle's smoothed course, its rate and second rate: a column each.
Eigen::MatrixXd withRates(const Eigen::VectorXd& angle, double dt);

}  // namespace nao::validation
