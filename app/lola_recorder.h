#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "daemon/lola_link.h"
#include "validation/log/robot_log.h"

namespace nao::app {

/// Records sets over the LoLA socket of a NAO V6: a row per frame, 12 ms apart, each answered by
/// the command of that row.
class LolaRecorder {
 public:
  LolaRecorder(daemon::LolaLink& link, std::shared_ptr<const RobotModel> model);

  /// A run of a standard motion: to its first pose in 3 s, a second of rest, then the motion.
  validation::LogRun play(std::size_t motion, int repeat);

  /// Everything of a set but its runs.
  validation::LogSet describe(const std::string& name) const;

 private:
  using Angles = std::vector<double>;  // [rad] in LoLA's order
  Angles order(const JointArray<double>& angles) const;
  std::string exchange(const Angles& command);
  void glideTo(const Angles& goal);

  daemon::LolaLink& link_;
  std::shared_ptr<const RobotModel> model_;
  Angles command_;  // sent last
};

}  // namespace nao::app
