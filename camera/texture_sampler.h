#pragma once

#include "camera/conic.h"
#include "camera/raster.h"
#include "core/texture.h"

namespace nao::camera {

/// The paint at one place of a texture, where one pixel of the picture is as large as `size` of the
/// texture's.
Pixel sampleAt(const Texture& texture, double right, double down, double size);

/// The paint of a texture at a pixel's centre, mixed from the four pixels around in each of the
/// two levels whose pixels are about as large as the picture's; pixels of the texture that are
/// larger stay squares with sharp borders. `right` and `down` are places on
/// the texture (0 to 1, held at its border) over depth, linear over the picture as inverse_depth
/// is.
Pixel sample(const Texture& texture, const LinearForm& right, const LinearForm& down,
             const LinearForm& inverse_depth, double u, double v);

}  // namespace nao::camera
