#pragma once

#include <array>
#include <vector>

#include "core/shape.h"

namespace nao::camera {

/// A convex solid of unit size, fitted to a shape by stretching: a vertex stands at
/// stretch * corner + (0, 0, end * half_length). So one capsule mesh serves every capsule.
struct Mesh {
  struct Vertex {
    Vec3 corner;
    Vec3 normal;
    double end = 0;  // -1, 0 or 1
  };
  std::vector<Vertex> vertices;
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise seen from outside
};

/// How round things are drawn: 8, 16 or 32 corners to a circle.
enum class Roundness { Coarse, Medium, Fine };

/// Made once, then read only.
class MeshLibrary {
 public:
  MeshLibrary();

  /// The mesh of a box, cylinder or capsule (a sphere is a capsule without length). A hull brings
  /// its own.
  const Mesh& find(Shape::Kind kind, Roundness roundness) const;

 private:
  Mesh box_;
  std::array<Mesh, 3> cylinders_;
  std::array<Mesh, 3> capsules_;
};

/// How far a mesh is stretched to become this shape.
struct Stretch {
  Vec3 scale;
  double half_length = 0;  // [m]
};
Stretch stretchOf(const Shape& shape);

/// Radius [m] of the sphere about the shape's centre that holds all of it.
double boundingRadius(const Shape& shape);

/// Distance [m] from the shape's surface to a point given in the shape's frame; negative inside.
/// For all but spheres and capsules a lower bound outside.
double distanceTo(const Shape& shape, const Vec3& p_S);

}  // namespace nao::camera
