#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/robot_io.h"
#include "validation/diagnosis/load_torque.h"

namespace nao::validation {

/// The loads of all joints of a robot with a fixed base over one run.
struct WholeLoad {
  int per_row = 1;          // values per row of the run
  Eigen::MatrixXd torque;   // [N m] a row per value, a column per joint
  Eigen::MatrixXd inertia;  // [kg m^2]
  Eigen::MatrixXd angle;    // [rad] of the links, the first hinge of each motor
  Eigen::MatrixXd slope;    // [N m/rad]

  sim::JointLoad of(Joint joint) const;
  std::vector<double> angleOf(Joint joint) const;
};

/// How a whole robot is run for its loads.
struct WholeLoadOptions {
  double settle = 0.5;  // [s]
  Duration step = std::chrono::microseconds(250);
  int per_row = 10;  // 1 ms for a Nao's cycle: orders come in stairs, which shake the neighbours
  double bandwidth = kLoadBandwidth;
};

/// `values`, one per row, on `per_row` values per row, linear between.
Eigen::VectorXd spreadOut(const std::vector<double>& rows, int per_row);

/// The model with these effects plays `orders` (one per row, a row is a cycle of the robot): that
/// gives the motion between the rows. What the joints were measured to do otherwise, smoothed to
/// the bandwidth, is added, and inverse dynamics of the sum are the loads.
WholeLoad calcWholeLoad(const RobotModel& model, const std::vector<EffectSetting>& effects,
                        const std::vector<JointCommand>& orders, const MeasuredMotion& measured,
                        const WholeLoadOptions& options, const sim::EffectCatalogue& catalogue);

}  // namespace nao::validation
