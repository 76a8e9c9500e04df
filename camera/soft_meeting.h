#pragma once

#include "camera/conic.h"
#include "camera/raster.h"

namespace nao::camera {

/// Mixes the two sides where solids cut into each other or into the ground, each pixel by the part
/// that either covers. For pictures on which everything is painted.
void softenMeetings(const LinearForm& ground_inverse_depth, Raster& raster);

}  // namespace nao::camera
