#pragma once

#include <functional>
#include <memory>
#include <string>

#include "naoqi_api/robot_link.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/behavior_library.h"

namespace nao::services {

/// ALFrameManager: plays behaviors, and motions of every other kind, that clients send as text or
/// that are installed (`library`, which may be null). `warn` is told, one sentence each, what of a
/// behavior is left out. `link` must outlive the service. I/O thread.
std::shared_ptr<rpc::Service> makeAlFrameManager(
    RobotLink& link, std::function<void(const std::string&)> warn = {},
    std::shared_ptr<const BehaviorLibrary> library = nullptr);

}  // namespace nao::services
