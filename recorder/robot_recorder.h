#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "daemon/qi_client.h"
#include "recorder/memory_rows.h"
#include "validation/log/floor_motions.h"
#include "validation/log/robot_log.h"

namespace nao::recorder {

/// Records sets from a robot that speaks NaoQi, real or simulated: plays motions by
/// ALMotion.angleInterpolation and reads rows from ALMemory meanwhile. What was commanded is read
/// back from the robot.
class RobotRecorder {
 public:
  /// `moving`: the joints that motions move; empty: all. @throws InputError for an unknown one.
  RobotRecorder(daemon::QiClient& client, std::shared_ptr<const RobotModel> model,
                const std::vector<std::string>& moving);

  /// Stands the robot up, for standing and walking motions.
  void wakeUp();

  /// The joints that motions move.
  std::vector<std::string> moving() const;

  /// A run of a standard motion: to its first pose in 3 s, a second of rest, then the motion. Time
  /// 0 is the row before the commands begin to change.
  validation::LogRun play(std::size_t motion, int repeat);

  /// A run of a standing or walking motion: StandInit by ALRobotPosture, then the motion.
  validation::LogRun play(const validation::FloorMotion& motion, int repeat);

  /// What the robot does in the next `seconds`, whatever it is.
  validation::LogRun watch(double seconds);

  /// Everything of a set but its runs.
  validation::LogSet describe(const std::string& name) const;

 private:
  using Angles = std::function<JointArray<double>(double t)>;
  using Arguments = std::vector<rpc::Value>;
  Arguments glideToRest() const;
  Arguments interpolation(const Angles& angles, double duration) const;
  void record(validation::LogRun& run, const char* method, const Arguments& arguments,
              double duration);

  daemon::QiClient& client_;
  std::shared_ptr<const RobotModel> model_;
  std::vector<std::size_t> moving_;
  MemoryRows rows_;
};

}  // namespace nao::recorder
