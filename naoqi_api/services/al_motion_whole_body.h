#pragma once

#include <map>
#include <string>

#include "core/frames.h"
#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that moves the whole body at once and keeps it in balance.
class AlMotionWholeBody {
 public:
  explicit AlMotionWholeBody(RobotLink& link) : link_(link) {}
  void declare(rpc::Service& service);

 private:
  void declareInner(rpc::Service& service);
  void declareEffectors(rpc::Service& service);
  void declareWeights(rpc::Service& service);

  void wbEnable(bool on);
  void wbFootState(const std::string& state, const std::string& feet);
  void wbEnableBalanceConstraint(bool on, const std::string& feet);
  rpc::Pending<bool> wbGoToBalance(const std::string& feet, float seconds);
  rpc::Pending<bool> wbGoToBalanceWithSpeed(const std::string& feet, float fraction);
  void wbEnableEffectorControl(const std::string& chain, bool on);
  void wbSetEffectorControl(const std::string& chain, const rpc::Value& target);
  void wbEnableEffectorOptimization(const std::string& chain, bool on);
  void updateTrackerTarget(float wy, float wz, int age_ms, bool whole_body);
  void lookAlong(const Vec3& direction_R);  // with the head; in the robot's frame

  /// What was asked for, for methods that tell it.
  struct Asked {
    bool enabled = false;
    std::string balance;  // Legs, LLeg, RLeg; none
    std::map<std::string, std::string> feet{{"LLeg", "Free"}, {"RLeg", "Free"}};
    std::map<std::string, bool> controlled, optimized;  // by effector
  };
  RobotLink& link_;
  Asked asked_;
};

}  // namespace nao::services
