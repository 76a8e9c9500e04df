#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/frames.h"

namespace nao {

/// A convex solid with flat faces.
struct Hull {
  struct Face {
    std::array<int, 3> corners;  // counter-clockwise seen from outside
    Vec3 normal;                 // unit, outwards
    double offset = 0;           // [m] normal . p of its points
  };
  std::vector<Vec3> corners;              // [m]
  std::vector<Face> faces;                // triangles
  std::vector<std::array<int, 2>> edges;  // between faces that are not in one plane
  double radius = 0;                      // [m] of the sphere about the origin that holds it
};

/// The smallest convex solid that holds all `points`; without faces if they lie in one plane.
Hull calcHull(const std::vector<Vec3>& points);

/// The corners in an OBJ file: its lines `v x y z`; all else is left out, since the faces are made
/// anew. @throws InputError naming file and line.
std::vector<Vec3> readObjCorners(const std::string& file);

}  // namespace nao
