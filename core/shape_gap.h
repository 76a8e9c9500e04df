#pragma once

#include "core/shape.h"

namespace nao {

/// Where two solids are nearest to each other, or deepest in each other.
struct ShapeGap {
  double distance = 0;       // [m] negative: how deep they are in each other
  Vec3 p_W = Vec3::Zero();   // [m] halfway between the two surfaces
  Vec3 n_W = Vec3::UnitZ();  // unit, from b towards a
};

/// The gap between two solids that stand in W at these poses (of their own frames). Exact for
/// solids apart of which one is a sphere or capsule or both have flat faces; cylinders beside
/// other cylinders or flat solids count as prisms of 16 sides. Within each other, the deepest point
/// of an edge (or axis) of one in the other.
ShapeGap calcShapeGap(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB);

}  // namespace nao
