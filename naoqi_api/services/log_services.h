#pragma once

#include <memory>
#include <vector>

#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// LogManager, whose listeners hear what others log, and ALLogger, NAOqi 1.x' way to log.
std::vector<std::shared_ptr<rpc::Service>> makeLogServices(const ServiceContext& context);

}  // namespace nao::services
