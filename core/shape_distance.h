#pragma once

#include "core/shape.h"

namespace nao {

/// Where a point is relative to a solid.
struct SurfacePoint {
  double distance = 0;          // [m] to the surface; negative inside
  Vec3 normal = Vec3::UnitZ();  // unit, outwards, from the surface towards the point
};

/// The surface of `shape` next to the point `p_S`, both in the shape's own frame.
SurfacePoint calcSurfacePoint(const Shape& shape, const Vec3& p_S);

/// The radius [m] of a sphere about the shape's centre that holds all of it.
double boundingRadius(const Shape& shape);

}  // namespace nao
