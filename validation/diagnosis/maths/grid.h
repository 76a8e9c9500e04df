#pragma once

#include <map>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/robot_model.h"
#include "validation/log/robot_log.h"

namespace nao::validation {

/// All runs of one motion and split of a set on one grid of times, 0, dt, 2 dt ... to the end of
/// the shortest run, in the model's own angles (axis signs and zeros of the set undone).
struct GriddedMotion {
  std::string motion;
  Split split = Split::Fit;
  double dt = 0;  // [s]
  std::size_t rows = 0;
  double kp_scale = 1;
  std::optional<LogLoad> load;
  std::string start_pose;
  struct Run {
    /// By joint: what was ordered (held from row to row), angles and currents (linear between the
    /// rows of the file); empty where a run does not have the signal.
    std::map<Joint, std::vector<double>> command, stiffness, angle, current;
  };
  std::vector<Run> runs;
};

/// The motions of a set, in the order of their first runs, on grids of the set's nominal rate.
/// @throws InputError for a joint that the model does not have, for runs of one motion that
/// differ in gain or load, and for a run whose times do not begin about 0 or leave no rows to speak
/// of.
std::vector<GriddedMotion> griddedMotions(const LogSet& set, const RobotModel& model);

}  // namespace nao::validation
