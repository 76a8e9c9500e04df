#pragma once

#include <memory>
#include <vector>

#include "camera/image_feed.h"
#include "naoqi_api/service.h"
#include "naoqi_api/services/service_context.h"

namespace nao::services {

/// ALRedBallDetection, ALRedBallTracker and ALTracker: a red ball is looked for in the pictures of
/// the active head camera, and a tracker turns the head to it. Other targets, whole bodies and
/// walks are kept as wishes and not followed.
std::vector<std::shared_ptr<rpc::Service>> makeBallServices(
    const ServiceContext& context, const std::shared_ptr<camera::ImageFeed>& images);

}  // namespace nao::services
