#pragma once

#include <string>

#include "camera/ground_truth.h"
#include "camera/raster.h"
#include "camera/view.h"
#include "core/scene_frame.h"

namespace nao::validation {

/// 16 hexadecimal digits that two different pictures are most unlikely to share.
std::string hashOf(const camera::Raster& picture);

/// One picture as JSON: its hash, the camera's place and pinhole, and the boxes of what is seen.
std::string toJson(const camera::Raster& picture, const camera::View& view,
                   const camera::GroundTruth& truth, const SceneFrame& scene);

}  // namespace nao::validation
