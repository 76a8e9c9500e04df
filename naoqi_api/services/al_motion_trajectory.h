#pragma once

#include <memory>
#include <vector>

#include "core/frames.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The control points of a way over the floor, in the frame in which it begins:
///   way  = ["Composed", way, ...] | ["Holonomic", line, turn [rad], seconds] | line
///   line = ["Line", [x, y]] | ["Circle", [x, y] of its centre, angle [rad]] | ["Composed", line,
///   ...]
/// A line's points are relative to where it begins; without "Holonomic" the robot keeps its
/// heading.
/// @throws CallError if it is something else, or too long.
std::vector<Pose2> readWay(const rpc::Value& way);

/// ALMotion's walks along such ways, by its methods with an underscore. Steps take their own time,
/// and the robot stands at every corner. I/O thread.
class AlMotionTrajectory {
 public:
  explicit AlMotionTrajectory(RobotLink& link) : link_(link) {}

  /// After the walk, whose moveTo it uses.
  void declare(rpc::Service& service);

 private:
  void declareFollowing(rpc::Service& service);
  void declareMoving(rpc::Service& service);
  void declareTelling(rpc::Service& service);
  /// @param start of the way, in the odometry's world
  rpc::Pending<int> walk(rpc::Service& service, const rpc::Value& way, const Pose2& start,
                         const rpc::Value& config);
  std::vector<Pose2> left() const;

  RobotLink& link_;
  std::vector<Pose2> points_;  // of the last way, in the odometry's world
  int id_ = 0;
  bool walking_ = false;
};

}  // namespace nao::services
