#pragma once

#include <string>
#include <vector>

#include "motion/kinematics.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that walks and knows where it walked to. Every method has its name of 1.12
/// too (walkTo, stopWalk, ...).
class AlMotionWalk {
 public:
  explicit AlMotionWalk(RobotLink& link) : link_(link), kinematics_(link.sharedModel()) {}
  void declare(rpc::Service& service);

 private:
  void declareVelocities(rpc::Service& service);
  void declareTargets(rpc::Service& service);
  void declareEnds(rpc::Service& service);
  void declareReadings(rpc::Service& service);

  void move(float x, float y, float theta);
  void moveWith(float x, float y, float theta, const rpc::Value& config);
  void moveToward(float x, float y, float theta);
  void moveTowardWith(float x, float y, float theta, const rpc::Value& config);
  void setWalkTargetVelocity(float x, float y, float theta, float frequency);
  void setWalkTargetVelocityWith(float x, float y, float theta, float frequency,
                                 const rpc::Value& config);
  void setWalkTargetVelocityWithBoth(float x, float y, float theta, float frequency,
                                     const rpc::Value& left, const rpc::Value& right);

  rpc::Pending<void> moveTo(float x, float y, float theta);
  rpc::Pending<void> moveToIn(float x, float y, float theta, float time);
  rpc::Pending<void> moveToWith(float x, float y, float theta, const rpc::Value& config);
  rpc::Pending<void> moveToInWith(float x, float y, float theta, float time,
                                  const rpc::Value& config);
  rpc::Pending<void> movePath(const rpc::Value& points);
  rpc::Pending<void> movePathWith(const rpc::Value& points, const rpc::Value& config);
  void walkOn(const std::vector<Pose2>& path, std::size_t next, const motion::GaitConfig& config,
              const rpc::Pending<void>& done);

  rpc::Pending<void> moveInit();
  rpc::Pending<void> waitUntilMoveIsFinished();
  rpc::Pending<bool> moveIsActive();
  rpc::Pending<void> stopMove();
  void killMove();

  rpc::Pending<std::vector<float>> getRobotPosition(bool use_sensors);
  Pose2 sensedPosition();
  rpc::Pending<std::vector<float>> getNextRobotPosition();
  rpc::Pending<std::vector<float>> getRobotVelocity();
  rpc::Pending<rpc::Value> getFootSteps();
  rpc::Value getMoveConfig(const std::string& which);

  RobotLink& link_;
  motion::Kinematics kinematics_;
};

}  // namespace nao::services
