#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// What a run of a whole robot shows, on even rows from its first one on: what the robot was told
/// and what came of it. A signal that the run does not have has no columns.
struct WholeRun {
  double dt = 0;                       // [s] between rows
  Eigen::MatrixXd command, stiffness;  // [rad], a column per joint of the model
  Eigen::MatrixXd angle;               // [rad] likewise; of joints that were not measured: 0
  Eigen::MatrixXd tilt;                // [rad] roll and pitch of the torso, as its board fuses them
  Eigen::MatrixXd acceleration;        // [m/s^2] of its accelerometer, x, y, z in T
  Eigen::MatrixXd turning;             // [rad/s] of its gyroscope about x, y and, if it has one, z
  Eigen::MatrixXd weight;              // [N] on the left and on the right sole
  /// x, y [m] and yaw [rad] of the torso, from where it was in the first row and ahead as it looked
  /// there; headings go on beyond half a turn. Without yaw if only the place was measured.
  Eigen::MatrixXd place;
  bool fell = false;    // the torso leant by more than 45 degrees
  double kp_scale = 1;  // P gain of the servos over the nominal model's
  std::optional<LogLoad> load;

  Eigen::Index rows() const { return command.rows(); }
};

/// A run of a set, axis signs and zeros undone. Joints without commands rest in the run's start
/// pose. @throws InputError with the run's file if it has less than two rows.
WholeRun wholeRunOf(const LogRun& run, const LogSet& set, const RobotModel& model);

/// Joints whose commands and angles every run of the set has.
std::vector<Joint> jointsMeasured(const LogSet& set, const RobotModel& model);

/// `X` by row (x, y, yaw in any frame) as WholeRun::place says.
Eigen::MatrixXd fromFirstRow(const Eigen::MatrixXd& place);

}  // namespace nao::validation
