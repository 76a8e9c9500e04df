#pragma once

#include <memory>
#include <string>

#include <Eigen/Core>

#include "sim/effects/catalogue.h"
#include "validation/diagnosis/ensemble/joint_simulator.h"

namespace nao::validation {

/// A course that a simulated joint is led along by a stiff spring and damper, and what these had to
/// do: the torque that the model lacks there. An effect like others, of one run each; the object
/// must outlive the run.
class LedJoint {
 public:
  /// `angle` [rad] per row, of which the encoder reads `misread` [rad] too much, rows `row` seconds
  /// apart, the first held for `settle` seconds before; smoothed here. `inertia` [kg m^2] of what
  /// is led; `reach` [rad]: by how much its servo may be off before the motor gives all it has.
  LedJoint(const Eigen::VectorXd& angle, const Eigen::VectorXd& misread, double row, double settle,
           double inertia, double reach);
  LedJoint(const LedJoint&) = delete;
  LedJoint& operator=(const LedJoint&) = delete;

  static constexpr char kName[] = "led_joint";
  /// The catalogue with this effect in it.
  sim::EffectCatalogue in(sim::EffectCatalogue catalogue);
  /// Means over every row of time.
  LedRun found() const;

 private:
  class Lead;

  Eigen::VectorXd angle_, rate_, misread_;
  double row_, settle_, reach_;
  double stiffness_, damping_;  // [N m/rad], [N m s/rad]
  LedRun sum_;
  Eigen::VectorXd steps_;  // of every row
};

/// An angle's smoothed course, its rate and second rate: a column each.
Eigen::MatrixXd withRates(const Eigen::VectorXd& angle, double dt);

}  // namespace nao::validation
