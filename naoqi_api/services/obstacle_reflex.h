#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "motion/kinematics.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// ALMotion's protection against what stands around the robot: a walk that leads ahead ends, or
/// does not begin, when the sonar hears something nearer than the security distance. That lies
/// between the tangential and the orthogonal one, as far as the walk's velocity lies between 0 and
/// its top (2.1 documentation). An arm is never slowed: a Nao has nothing that would see beside it.
/// I/O thread.
class ObstacleReflex {
 public:
  explicit ObstacleReflex(RobotLink& link) : link_(link), kinematics_(link.sharedModel()) {}
  void declare(rpc::Service& service);

  /// Whether a walk was under way that ended, or never began.
  enum class Walk { Refused, Ended };

  /// After each cycle of the robot. Nothing happens until `enable`, as NAOqi 1.x has no such
  /// reflex; `stopped` gets the place of what was in the way of a walk, in the robot's frame.
  void deliver();
  using Stopped = std::function<void(const Vec3& place, Walk walk)>;
  void enable(Stopped stopped) { stopped_ = std::move(stopped); }

  /// Has ALMotion's walks asked about first; once, after all are declared. One that is refused
  /// returns at once, false if it returns a bool.
  void guard(rpc::Service& service);

 private:
  void declareDistances(rpc::Service& service);
  bool isOn(const std::string& name) const;
  void set(const std::string& name, bool on);
  std::vector<std::string> protectedParts() const;
  std::optional<Vec3> nearest();  // in R
  std::optional<Vec3> inTheWay(double part_of_top_speed);
  std::optional<Vec3> heard(std::size_t receiver) const;
  std::vector<float> closest(const std::string& name, int space);

  RobotLink& link_;
  motion::Kinematics kinematics_;
  Stopped stopped_;
  std::map<std::string, bool> off_;    // by chain, and Move
  std::vector<Eigen::Vector2d> told_;  // obstacles that a client told of, in W [m]
  float orthogonal_distance_ = 0.4F;   // [m] NaoQi's default
  float tangential_distance_ = 0.1F;   // [m] NaoQi's default
  bool stopping_ = false;
};

}  // namespace nao::services
