#pragma once

#include <memory>

#include "naoqi_api/services/ball_watch.h"
#include "naoqi_api/services/make_module.h"

namespace nao::services {

/// ALTracker: head, body or steps follow a red ball, or the places an event tells; other targets
/// are kept and never seen. Tells its events ten times a second at most. I/O thread.
ServicePointer makeAlTracker(const ServiceContext& context,
                             const std::shared_ptr<BallWatch>& watch);

}  // namespace nao::services
