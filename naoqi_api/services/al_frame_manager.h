#pragma once

#include <functional>
#include <memory>
#include <string>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"

namespace nao::services {

/// ALFrameManager: plays Choregraphe behaviors that clients send as text. `warn` is told, one
/// sentence each, what of a behavior is left out. `link` must outlive the service. I/O thread.
std::shared_ptr<rpc::Service> makeAlFrameManager(RobotLink& link,
                                                 std::function<void(const std::string&)> warn = {});

}  // namespace nao::services
