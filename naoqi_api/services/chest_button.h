#pragma once

#include <memory>

#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// ALChestButton: tells how often the button was clicked in a row, once, twice or three times.
std::shared_ptr<rpc::Service> makeChestButton(const ServiceContext& context);

}  // namespace nao::services
