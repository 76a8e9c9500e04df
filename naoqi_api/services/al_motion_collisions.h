#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/shape.h"
#include "motion/kinematics.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that tells of solids around the links, and which are near to each other.
/// Nobody documents these methods; they do what their names and arguments say. I/O thread.
class AlMotionCollisions {
 public:
  explicit AlMotionCollisions(RobotLink& link) : link_(link), kinematics_(link.sharedModel()) {}

  /// After isCollision, which one of these asks.
  void declare(rpc::Service& service);

 private:
  void declareSetting(rpc::Service& service);
  const std::vector<Shape>& shapesOf(std::size_t body) const;
  rpc::Value getShapes(const std::string& name) const;
  rpc::Value getDetected(float nearer);
  double gapBetween(std::size_t a, std::size_t b) const;  // [m]
  void setShapes(const std::vector<std::string>& links, const std::vector<Shape>& shapes);

  RobotLink& link_;
  motion::Kinematics kinematics_;
  std::map<std::size_t, std::vector<Shape>> told_;  // by body, in place of the robot file's
};

}  // namespace nao::services
