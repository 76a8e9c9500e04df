#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "motion/kinematics.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// What ALMotion tells of the time before: where sensors were, how far the robot has walked, how
/// often a command jumped. Nobody documents these methods; they do what their names say. I/O
/// thread.
class MotionHistory {
 public:
  /// `epoch`: NaoQi's clock when simulated time is 0.
  explicit MotionHistory(RobotLink& link, Duration epoch = {})
      : link_(link), epoch_(epoch), kinematics_(link.sharedModel()) {}

  void declare(rpc::Service& service);

  /// After each cycle of the robot. When time was set back, the history begins anew; what is
  /// counted goes on.
  void deliver();

 private:
  struct Moment {
    SimTime time{};
    JointArray<double> angle;  // [rad] measured
  };
  void remember(const SensorFrame& sensors);
  void countJumps(const motion::MotionState& state, double dt);
  void addWay(const motion::MotionState& state);
  JointArray<double> anglesAt(SimTime time) const;
  std::vector<float> transformAt(const std::string& sensor, SimTime time);

  RobotLink& link_;
  Duration epoch_;
  motion::Kinematics kinematics_;
  std::deque<Moment> moments_;  // oldest first
  std::uint64_t set_back_ = 0;
  bool has_seen_ = false;  // the members below are of a cycle
  SimTime seen_{};
  JointArray<double> command_;  // [rad]
  Pose2 position_;
  Pose2 way_;  // along each axis, forth and back
  std::uint32_t jumps_ = 0;
};

}  // namespace nao::services
