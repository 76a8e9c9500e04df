#pragma once

#include <array>
#include <map>
#include <memory>
#include <vector>

#include "core/shape.h"

namespace nao::camera {

/// A solid of unit size, fitted to a shape by stretching: a vertex stands at
/// stretch * corner + (0, 0, end * half_length). So one capsule mesh serves every capsule.
struct Mesh {
  struct Vertex {
    Vec3 corner;
    Vec3 normal;
    double end = 0;                                     // -1, 0 or 1
    Eigen::Vector2d texture = Eigen::Vector2d::Zero();  // 0 to 1: right, down
  };
  /// Where two triangles meet, by index; -1: nothing on that side. At a crease they differ in
  /// light, so their border is seen although both face the eye.
  struct Edge {
    int from = 0;  // vertices
    int to = 0;
    std::array<int, 2> triangles = {-1, -1};
    bool is_crease = false;
  };
  std::vector<Vertex> vertices;
  std::vector<std::array<int, 3>> triangles;  // counter-clockwise seen from outside
  std::vector<Edge> edges;
};

/// Finds the edges of a mesh that has vertices and triangles. Vertices in one place count as one.
void linkEdges(Mesh& mesh);

/// How round things are drawn: 8, 16 or 32 corners to a circle.
enum class Roundness { Coarse, Medium, Fine };

/// The usual ones made once; those of hulls and files when first asked for.
class MeshLibrary {
 public:
  MeshLibrary();

  /// The mesh of a shape; a sphere is a capsule without length.
  const Mesh& find(const Shape& shape, Roundness roundness);

 private:
  const Mesh& ofHull(const std::shared_ptr<const Hull>& hull);
  const Mesh& ofFile(const std::shared_ptr<const ObjMesh>& mesh);

  Mesh box_;
  std::array<Mesh, 3> cylinders_;
  std::array<Mesh, 3> capsules_;
  std::map<std::shared_ptr<const Hull>, Mesh> hulls_;
  std::map<std::shared_ptr<const ObjMesh>, Mesh> files_;
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
