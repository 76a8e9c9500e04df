#pragma once

#include <memory>

#include "naoqi_api/service.h"

namespace nao::rpc {
class ServiceHub;
}

namespace nao::services {

/// ServiceDirectory, the service every client meets first: what services there are and where.
/// `hub` outlives it.
std::shared_ptr<rpc::Service> makeServiceDirectory(rpc::ServiceHub& hub);

}  // namespace nao::services
