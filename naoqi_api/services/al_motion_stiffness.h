#pragma once

#include <string>
#include <vector>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that switches motors on and off.
class AlMotionStiffness {
 public:
  explicit AlMotionStiffness(RobotLink& link) : link_(link) {}
  void declare(rpc::Service& service);

 private:
  rpc::Pending<void> wakeUp();
  rpc::Pending<void> rest();
  void restChain(const std::string& chain);
  rpc::Pending<bool> robotIsWakeUp();
  rpc::Pending<void> stiffnessInterpolation(const rpc::Value& names, const rpc::Value& stiffnesses,
                                            const rpc::Value& times);
  void setStiffnesses(const rpc::Value& names, const rpc::Value& stiffnesses);
  rpc::Pending<std::vector<float>> getStiffnesses(const rpc::Value& names);

  RobotLink& link_;
};

}  // namespace nao::services
