#pragma once

#include <string>
#include <vector>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that describes the robot: names, limits, configuration.
class AlMotionTools {
 public:
  explicit AlMotionTools(RobotLink& link) : link_(link) {}
  void declare(rpc::Service& service);

 private:
  std::vector<std::string> getBodyNames(const std::string& name);
  std::vector<std::string> getSensorNames();
  rpc::Value getLimits(const std::string& name);
  int getMotionCycleTime();
  rpc::Value getRobotConfig();
  rpc::Pending<std::string> getSummary();

  RobotLink& link_;
};

}  // namespace nao::services
