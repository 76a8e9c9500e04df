#pragma once

#include "naoqi_api/personality.h"
#include "naoqi_api/service_hub.h"

namespace nao::services {

/// Gives the methods of a robot's services the shapes of its NAOqi, where versions differ: one line
/// of a table each (version_shapes.cc). Once, when all services are there.
void applyVersion(rpc::ServiceHub& hub, const rpc::Personality& personality);

}  // namespace nao::services
