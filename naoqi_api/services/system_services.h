#pragma once

#include <memory>
#include <vector>

#include "naoqi_api/service.h"
#include "naoqi_api/service_hub.h"
#include "naoqi_api/services/behavior_runner.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// ALRobotModel, ALRobotPose, ALPreferences, ALPreferenceManager, ALLauncher, ALServiceManager,
/// PackageManager: what clients ask of the robot itself and of what is installed on it. `hub`
/// outlives the services.
std::vector<std::shared_ptr<rpc::Service>> makeSystemServices(
    const ServiceContext& context, const std::shared_ptr<BehaviorRunner>& behaviors,
    const rpc::ServiceHub& hub);

}  // namespace nao::services
