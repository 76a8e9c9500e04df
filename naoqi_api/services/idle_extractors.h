#pragma once

#include <memory>
#include <vector>

#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// Extractors for what the simulated world does not have: people, faces, marks, sounds. They can
/// be subscribed to, configured, paused, and never see or hear anything.
std::vector<std::shared_ptr<rpc::Service>> makeIdleExtractors(const ServiceContext& context);

}  // namespace nao::services
