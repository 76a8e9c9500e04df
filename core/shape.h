#pragma once

#include <memory>

#include "core/frames.h"
#include "core/hull.h"

namespace nao {

/// 8-bit red, green, blue.
struct Color {
  unsigned char red = 200;
  unsigned char green = 200;
  unsigned char blue = 200;
};

/// A solid primitive fixed to a body or to the world.
struct Shape {
  enum class Kind { Sphere, Box, Cylinder, Capsule, Hull };
  Kind kind = Kind::Sphere;
  Pose X_BS = Pose::Identity();  // shape's centre in its body (or in W)
  Vec3 size = Vec3::Zero();      // [m] box: full edges. others: x radius, z length along local z
                                 // (capsule: between the centres of its caps)
  Color color;
  std::shared_ptr<const nao::Hull> hull;  // of a Hull, in the shape's frame
};

}  // namespace nao
