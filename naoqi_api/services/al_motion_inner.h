#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "motion/kinematics.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The methods of ALMotion that begin with an underscore, with the names, shapes and ids of a V5.
/// Nobody documents them: what they do here is what their names and arguments say.
class AlMotionInner {
 public:
  explicit AlMotionInner(RobotLink& link) : link_(link), kinematics_(link.sharedModel()) {}

  /// After all other parts: some of these are other names of what they declare.
  void declare(rpc::Service& service);

 private:
  void declareSame(rpc::Service& service);
  void declareBody(rpc::Service& service);
  void declareGround(rpc::Service& service);
  void declareMoving(rpc::Service& service);
  void declareOrders(rpc::Service& service);
  void declareBalance(rpc::Service& service);
  void declareLooking(rpc::Service& service);
  void declareKept(rpc::Service& service);
  void declareBlindZones(rpc::Service& service);

  Pose torsoInWorld(bool use_sensors);  // X_WT, W: the odometry's
  std::vector<float> getMotionPosture(const std::string& name) const;
  bool setMotionPosture(const std::string& name, const std::vector<float>& angles);
  std::vector<float> getInertia(const std::string& body) const;
  rpc::Value getFullLimits(const std::string& name) const;
  std::vector<std::vector<float>> getGroundHull();
  rpc::Pending<std::vector<int>> getMoving(bool use_sensors, bool chains);
  std::vector<int> compare(const JointArray<double>& before, const JointArray<double>& after,
                           bool chains) const;
  void lookAt(const std::vector<float>& target, int frame, float fraction);
  void holdStill(const char* group);

  RobotLink& link_;
  motion::Kinematics kinematics_;
  std::map<std::string, std::vector<float>> kept_postures_;  // [rad] of Body, by name
};

}  // namespace nao::services
