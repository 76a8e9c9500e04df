#pragma once

#include <almath/types/alvectorspace.h>

namespace AL {
namespace Math {

/// A turn as four numbers of norm 1. a * b: first b, then a.
struct Quaternion {
  float w;
  float x;
  float y;
  float z;

  Quaternion() : w(1), x(0), y(0), z(0) {}
  Quaternion(float its_w, float its_x, float its_y, float its_z)
      : w(its_w), x(its_x), y(its_y), z(its_z) {}

  /// By `angle` about the unit vector (ux, uy, uz).
  static Quaternion fromAngleAndAxisRotation(float angle, float ux, float uy, float uz) {
    const float s = std::sin(angle / 2);
    return Quaternion(std::cos(angle / 2), s * ux, s * uy, s * uz);
  }
  Quaternion operator*(const Quaternion& o) const {
    return Quaternion(w * o.w - x * o.x - y * o.y - z * o.z, w * o.x + x * o.w + y * o.z - z * o.y,
                      w * o.y - x * o.z + y * o.w + z * o.x, w * o.z + x * o.y - y * o.x + z * o.w);
  }
  Quaternion& operator*=(const Quaternion& other) { return *this = *this * other; }
  bool isNear(const Quaternion& o, float epsilon = 0.0001f) const {
    return std::fabs(w - o.w) <= epsilon && std::fabs(x - o.x) <= epsilon &&
           std::fabs(y - o.y) <= epsilon && std::fabs(z - o.z) <= epsilon;
  }
  bool operator==(const Quaternion& other) const { return isNear(other, 0); }
  bool operator!=(const Quaternion& other) const { return !(*this == other); }
  float norm() const { return std::sqrt(w * w + x * x + y * y + z * z); }
  /// @throws std::runtime_error for 0
  Quaternion normalize() const {
    const float length = norm();
    if (length == 0) throw std::runtime_error("ALMath: a quaternion of 0 has no direction");
    return Quaternion(w / length, x / length, y / length, z / length);
  }
  Quaternion inverse() const { return Quaternion(w, -x, -y, -z); }
  std::vector<float> toVector() const {
    const float all[] = {w, x, y, z};
    return std::vector<float>(all, all + 4);
  }
};

inline Quaternion quaternionInverse(const Quaternion& quaternion) { return quaternion.inverse(); }
inline Quaternion quaternionFromAngleAndAxisRotation(float angle, float ux, float uy, float uz) {
  return Quaternion::fromAngleAndAxisRotation(angle, ux, uy, uz);
}

}  // namespace Math
}  // namespace AL
