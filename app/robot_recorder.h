#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/robot_model.h"
#include "daemon/qi_client.h"
#include "validation/log/floor_motions.h"
#include "validation/log/robot_log.h"

namespace nao::app {

/// Records sets from a robot that speaks NaoQi, real or simulated: polls ALMemory for what
/// RobotLog 1 has columns for, a row whenever the robot's own clock (DCM/Time) has gone on, and
/// plays motions by ALMotion.angleInterpolation. What was commanded is read back from the robot.
class RobotRecorder {
 public:
  /// `moving`: the joints that motions move; empty: all. @throws InputError for an unknown one.
  RobotRecorder(daemon::QiClient& client, std::shared_ptr<const RobotModel> model,
                const std::vector<std::string>& moving);

  /// Stiffens the joints that move and turns off what would interfere: fall manager, collision
  /// protection, smart stiffness. What the robot refuses is told on standard error.
  void prepare();

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
  struct Source {
    std::string key;
    std::string column;
    double scale = 1;
  };
  void findSources();
  void ask(const char* method, const std::vector<rpc::Value>& arguments);
  double poll(validation::LogRun& run);
  void glideToRest();
  using Angles = std::function<JointArray<double>(double t)>;
  daemon::QiClient::Ticket begin(const Angles& angles, double duration);
  void record(validation::LogRun& run, const daemon::QiClient::Ticket& ticket, double duration);

  daemon::QiClient& client_;
  std::shared_ptr<const RobotModel> model_;
  std::vector<std::size_t> moving_;
  std::vector<Source> sources_;
  rpc::Value keys_;   // of the sources, the clock first
  double begun_ = 0;  // [s] of the robot's clock, of the run
};

}  // namespace nao::app
