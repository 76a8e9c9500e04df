#pragma once

#include <almath/types/altransform.h>
#include <almath/types/alvelocity6d.h>

namespace AL {
namespace Math {

/// Where a body is and how it moves.
struct TransformAndVelocity6D {
  Transform T;
  Velocity6D V;

  TransformAndVelocity6D() {}
  TransformAndVelocity6D(const Transform& its_T, const Velocity6D& its_V) : T(its_T), V(its_V) {}

  /// Each number within `epsilon` of the other's.
  bool isNear(const TransformAndVelocity6D& other, float epsilon = 0.0001f) const {
    return T.isNear(other.T, epsilon) && V.isNear(other.V, epsilon);
  }
};

}  // namespace Math
}  // namespace AL
