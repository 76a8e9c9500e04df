#pragma once

#include <string>
#include <vector>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// The part of ALMotion that lists and ends motions. A motion's number is not the one .post gives.
class AlMotionTasks {
 public:
  explicit AlMotionTasks(RobotLink& link) : link_(link) {}
  void declare(rpc::Service& service);

 private:
  rpc::Pending<rpc::Value> getTaskList();
  rpc::Pending<bool> areResourcesAvailable(const std::vector<std::string>& names);
  rpc::Pending<bool> killTask(int task);
  rpc::Pending<void> killTasksUsingResources(const std::vector<std::string>& names);
  void killAll();

  std::vector<motion::RequestId> tasksUsing(const std::vector<Joint>& joints) const;

  RobotLink& link_;
};

}  // namespace nao::services
