#pragma once

#include <memory>

#include "core/color.h"
#include "core/frames.h"
#include "core/hull.h"
#include "core/obj_mesh.h"
#include "core/texture.h"

namespace nao {

/// A solid primitive fixed to a body or to the world.
struct Shape {
  enum class Kind { Sphere, Box, Cylinder, Capsule, Hull };
  Kind kind = Kind::Sphere;
  Pose X_BS = Pose::Identity();  // shape's centre in its body (or in W)
  Vec3 size = Vec3::Zero();      // [m] box: full edges. others: x radius, z length along local z
                                 // (capsule: between the centres of its caps)
  Color color;
  std::shared_ptr<const nao::Hull> hull;  // of a Hull, in the shape's frame
  // For the eye alone: triangles in place of a Hull's faces; paint, not on capsules and hulls.
  std::shared_ptr<const ObjMesh> mesh;
  std::shared_ptr<const Texture> texture;
};

}  // namespace nao
