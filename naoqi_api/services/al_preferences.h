#pragma once

#include <memory>
#include <vector>

#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// ALPreferenceManager, values by domain and key, and ALPreferences, whole files of them as 1.x has
/// it. Both outlive the daemon if there is a data directory.
std::vector<std::shared_ptr<rpc::Service>> makePreferences(const ServiceContext& context);

}  // namespace nao::services
