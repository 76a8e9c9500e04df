#pragma once

#include <memory>
#include <vector>

#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// The services that tell of the robot's sensors: ALSensors, ALTouch, ALFsr, ALSonar,
/// ALChestButton, ALSentinel, ALBattery, ALBodyTemperature. Touch and bumper events come from
/// MotionEvents; here are those of the sonar, the battery, the temperatures and TouchChanged.
std::vector<std::shared_ptr<rpc::Service>> makeBoardServices(const ServiceContext& context);

}  // namespace nao::services
