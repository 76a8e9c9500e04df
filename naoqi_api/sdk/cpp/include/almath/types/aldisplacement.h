#pragma once

#include <almath/types/alposition3d.h>
#include <almath/types/alquaternion.h>

namespace AL {
namespace Math {

/// A turn, then a shift [m]. a * b: first b, then a.
struct Displacement {
  Position3D P;
  Quaternion Q;

  /// None at all.
  Displacement() {}
  explicit Displacement(const Position3D& shift, const Quaternion& turn = Quaternion())
      : P(shift), Q(turn) {}

  Displacement operator*(const Displacement& other) const {
    return Displacement(P + Q * other.P, Q * other.Q);
  }
  Displacement& operator*=(const Displacement& other) { return *this = *this * other; }
  /// Each number within `epsilon` of the other's; q and -q are the same turn.
  bool isNear(const Displacement& other, float epsilon = 0.0001f) const {
    return P.isNear(other.P, epsilon) && Q.isNear(other.Q, epsilon);
  }
};

}  // namespace Math
}  // namespace AL
