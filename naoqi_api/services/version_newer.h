#pragma once

#include "naoqi_api/service_hub.h"

namespace nao::services {

/// Takes away the services and methods that came after a NAOqi's release (as Personality::release):
/// a table, version_newer.inc. Once, when all services are there and before a client is.
void removeNewer(rpc::ServiceHub& hub, int release);

}  // namespace nao::services
