#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "daemon/lola_link.h"
#include "validation/log/robot_log.h"

namespace nao::recorder {

/// Records sets over the LoLA socket of a NAO V6: a row per frame, 12 ms apart, each answered by
/// the command of that row.
class LolaRecorder {
 public:
  /// Every joint is stiffened where it is. `moving`: the joints that motions move; empty: all.
  /// @throws InputError for one that LoLA or the model does not have.
  LolaRecorder(daemon::LolaLink& link, std::shared_ptr<const RobotModel> model,
               const std::vector<std::string>& moving);

  /// A run of a standard motion: to its first pose in 3 s, a second of rest, then the motion.
  validation::LogRun play(std::size_t motion, int repeat);

  /// What the robot's sensors say in the next `seconds`, while it stays where it is.
  validation::LogRun watch(double seconds);

  /// Everything of a set but its runs.
  validation::LogSet describe(const std::string& name) const;

 private:
  using Angles = std::vector<double>;  // [rad] in LoLA's order
  Angles order(const JointArray<double>& angles) const;
  std::string exchange(const Angles& command);
  std::string hold(double seconds);
  void glideTo(const Angles& goal);

  daemon::LolaLink& link_;
  std::shared_ptr<const RobotModel> model_;
  std::vector<Joint> moves_;        // of the model
  std::vector<std::size_t> slots_;  // where LoLA has them
  Angles command_;                  // sent last
};

}  // namespace nao::recorder
