#pragma once

#include <string>
#include <vector>

#include "validation/log/robot_log.h"
#include "validation/report.h"

namespace nao::validation {

/// How one joint follows its command over the runs of a set: no model, no simulation.
struct JointError {
  std::string joint;
  double rms = 0;        // [rad] of command less angle
  double bias = 0;       // [rad] its mean
  double lag = 0;        // [s] by which the command is best shifted; 0 for a joint that rests, NaN:
                         // the runs are too short to tell
  double following = 1;  // slope of angle over shifted command; 1 for a joint that rests
  double moved = 0;      // [rad] range of its command
  double rest = 0;       // [rad] mean of the runs' errors where the command stands still
  std::vector<double> rest_biases, rmses;  // [rad] by run; of one that never rests, over all
};

/// A left joint and its right one, and what they differ by beyond what runs differ by.
struct SideDifference {
  std::string left, right;
  double rms = 0;         // [rad] left less right, of the errors' RMS
  double rms_error = 0;   // [rad] standard error of that, from run to run
  double bias = 0;        // [rad] of what is off at rest, mirrored if that makes them more alike
  double bias_error = 0;  // [rad]
  bool differs = false;
};

/// Joints with a command and an angle, in the order of the set. All runs are looked at, whatever
/// their split: nothing is fitted.
std::vector<JointError> errorMapOf(const LogSet& set);

/// Joints that are named alike but for l/r, L/R or left/right at their beginning.
std::vector<SideDifference> sideDifferences(const std::vector<JointError>& joints);

/// Both as tables. @throws InputError for a set without any joint of command and angle.
Report reportErrorMap(const LogSet& set);

}  // namespace nao::validation
