#pragma once

#include <algorithm>

#include "core/frames.h"

namespace nao::camera {

/// One broad lamp high above the field, and light from everywhere: a surface that faces up shows
/// its own colour, one that faces down four fifths of it. Free choices: a hall lit from many sides,
/// in which an orange ball stays bright enough on its shadow side to be found by colour.
inline constexpr double kAmbient = 0.78;

/// Towards the lamp, in W, not normalised.
inline Vec3 towardsLamp() { return Vec3(0.25, 0.15, 1.0); }

/// Strength 0 to 256 for the cosine between the surface's normal and the lamp's direction. The
/// lamp stands 16 degrees aside: the last factor makes up for it on surfaces that face up.
inline double lightStrength(double cosine) {
  return 256 * std::min(1.0, kAmbient + (1 - kAmbient) * (0.5 + 0.5 * cosine) * 1.04);
}

}  // namespace nao::camera
