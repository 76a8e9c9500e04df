#pragma once

#include <string>
#include <vector>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that takes steps one by one.
class AlMotionFootsteps {
 public:
  explicit AlMotionFootsteps(RobotLink& link) : link_(link) {}
  void declare(rpc::Service& service);

 private:
  void setFootSteps(const std::vector<std::string>& legs, const rpc::Value& steps,
                    const std::vector<float>& times, bool clear);
  rpc::Pending<void> setFootStepsWithSpeed(const std::vector<std::string>& legs,
                                           const rpc::Value& steps,
                                           const std::vector<float>& fractions, bool clear);

  RobotLink& link_;
};

}  // namespace nao::services
