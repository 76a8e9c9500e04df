#pragma once

#include <string>
#include <vector>

#include "motion/kinematics.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that says where things are: chains, sensors, the centre of mass. By the
/// joints alone; the world frame is that of the walk's odometry.
class AlMotionGeometry {
 public:
  explicit AlMotionGeometry(RobotLink& link) : link_(link), kinematics_(link.sharedModel()) {}
  void declare(rpc::Service& service);

 private:
  rpc::Pending<std::vector<float>> getPosition(const std::string& name, int space,
                                               bool use_sensors);
  rpc::Pending<std::vector<float>> getTransform(const std::string& name, int space,
                                                bool use_sensors);
  rpc::Pending<std::vector<float>> getCom(const std::string& name, int space, bool use_sensors);
  rpc::Pending<std::vector<std::vector<float>>> getSupportPolygon(int space, bool use_sensors);
  float getMass(const std::string& name);

  void update(bool use_sensors);
  std::vector<std::size_t> standingFeet(bool use_sensors) const;
  Pose poseOfTorsoIn(int space) const;  // X_FT for the space F
  Pose calcPose(const motion::Effector& place, int space, bool use_sensors);

  RobotLink& link_;
  motion::Kinematics kinematics_;
};

}  // namespace nao::services
