#pragma once

#include <memory>

#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// NaoQi's ALAudioPlayer: sounds are logged and take their time, and none is heard. A WAV file
/// below the data directory lasts as long as it says, anything else 3 s.
std::shared_ptr<rpc::Service> makeAlAudioPlayer(const ServiceContext& context);

}  // namespace nao::services
