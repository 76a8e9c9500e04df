#pragma once

#include "camera/raster.h"

namespace nao::camera {

/// Lays dirt over a picture as it lies on a lens, far out of focus: soft blotches that always lie
/// in the same places let less of the scene through and scatter the picture's mean light instead,
/// dimmed. With a dirt of 0 nothing happens; at 0.5 the blotches' middles are opaque, and at 1 all
/// of the picture is. Whole numbers throughout.
void layDirt(Raster& picture, float dirt);

}  // namespace nao::camera
