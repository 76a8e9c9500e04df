#pragma once

#include <array>
#include <cstdint>

#include "camera/image.h"
#include "camera/raster.h"

namespace nao::camera {

/// Three bytes of a pixel.
using Triple = std::array<std::uint8_t, 3>;

/// Y, U (Cb), V (Cr) by ITU-R BT.601 over the full range 0..255 (JFIF):
///   Y = .299 R + .587 G + .114 B,  U = 128 + .564 (B - Y),  V = 128 + .713 (R - Y)
Triple toYuv(Color color);

/// Hue (a full turn is 256, red 0, green 85), saturation (max - min) / max, and the Y above.
Triple toHsy(Color color);

/// Red, green, blue of the hue alone, at its fullest and brightest; grey is red, as its hue is 0.
Triple toPureHue(Color color);

/// Hue, saturation, and the mean of both.
Triple toHueSaturation(Color color);

/// The picture in this colour space. Two pixels that share U and V get the mean of both.
Bytes toBytes(const Raster& raster, ColorSpace space);

}  // namespace nao::camera
