#pragma once

#include <memory>
#include <vector>

#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// ALPreferenceManager, values by domain and key, and ALPreferences, whole files of them as 1.x has
/// it. Both keep what they are told in memory, until the daemon ends.
std::vector<std::shared_ptr<rpc::Service>> makePreferences(const ServiceContext& context);

}  // namespace nao::services
