#pragma once

#include <memory>

#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// NaoQi's ALAutonomousLife: its states and the changes it allows; no activity ever comes of them.
std::shared_ptr<rpc::Service> makeAlAutonomousLife(const ServiceContext& context);

}  // namespace nao::services
