#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/frames.h"

namespace nao {

/// Triangles of an OBJ file, for the eye: seen from the side on which their corners run
/// counter-clockwise.
struct ObjMesh {
  struct Corner {
    Vec3 p = Vec3::Zero();                              // [m]
    Vec3 normal = Vec3::Zero();                         // unit, outwards
    Eigen::Vector2d texture = Eigen::Vector2d::Zero();  // 0 to 1 of a picture: right, down
  };
  using Triangle = std::array<Corner, 3>;
  std::vector<Triangle> triangles;
};

/// Reads `v`, `vt`, `vn` and `f` of an OBJ file; a face of more corners becomes a fan of
/// triangles, one without normals is flat. Materials, groups and lines are left out.
/// @throws InputError naming file and line.
ObjMesh readObjMesh(const std::string& file);

}  // namespace nao
