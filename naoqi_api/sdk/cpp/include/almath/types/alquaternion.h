#pragma once

#include <algorithm>
#include <vector>

#include <almath/types/alposition3d.h>
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
  /// w, x, y, z. @throws std::runtime_error unless there are 4 numbers.
  explicit Quaternion(const std::vector<float>& numbers) {
    if (numbers.size() != 4) {
      throw std::runtime_error("ALMath: expected 4 numbers, found " +
                               std::to_string(numbers.size()));
    }
    *this = Quaternion(numbers[0], numbers[1], numbers[2], numbers[3]);
  }

  /// By `angle` [rad] about the unit vector (ux, uy, uz).
  static Quaternion fromAngleAndAxisRotation(float angle, float ux, float uy, float uz) {
    const float s = std::sin(angle / 2);
    return Quaternion(std::cos(angle / 2), s * ux, s * uy, s * uz);
  }
  Quaternion operator*(const Quaternion& o) const {
    return Quaternion(w * o.w - x * o.x - y * o.y - z * o.z, w * o.x + x * o.w + y * o.z - z * o.y,
                      w * o.y - x * o.z + y * o.w + z * o.x, w * o.z + x * o.y - y * o.x + z * o.w);
  }
  Quaternion& operator*=(const Quaternion& other) { return *this = *this * other; }
  Quaternion operator*(float factor) const {
    return Quaternion(w * factor, x * factor, y * factor, z * factor);
  }
  Quaternion& operator*=(float factor) { return *this = *this * factor; }
  /// @throws std::runtime_error for 0
  Quaternion operator/(float divisor) const {
    if (divisor == 0) throw std::runtime_error("ALMath: division by zero");
    return Quaternion(w / divisor, x / divisor, y / divisor, z / divisor);
  }
  Quaternion& operator/=(float divisor) { return *this = *this / divisor; }

  bool operator==(const Quaternion& o) const {
    return w == o.w && x == o.x && y == o.y && z == o.z;
  }
  bool operator!=(const Quaternion& other) const { return !(*this == other); }
  /// Whether both turn alike: each number within `epsilon` of the other's or of its negative.
  bool isNear(const Quaternion& other, float epsilon = 0.0001f) const {
    return areNear(other, epsilon) || areNear(other * -1.0f, epsilon);
  }

  float norm() const { return std::sqrt(w * w + x * x + y * y + z * z); }
  /// @throws std::runtime_error for 0
  Quaternion normalize() const {
    const float length = norm();
    if (length == 0) throw std::runtime_error("ALMath: a quaternion of 0 has no direction");
    return *this / length;
  }
  /// Times this it is 1, whatever the norm. @throws std::runtime_error for 0
  Quaternion inverse() const { return Quaternion(w, -x, -y, -z) / (norm() * norm()); }

  /// w, x, y, z.
  std::vector<float> toVector() const {
    const float all[] = {w, x, y, z};
    return std::vector<float>(all, all + 4);
  }
  void toVector(std::vector<float>& all) const { all = toVector(); }
  /// From `to` on, where there is room for them; `to` is moved behind them.
  void writeToVector(std::vector<float>::iterator& to) const {
    const std::vector<float> all = toVector();
    to = std::copy(all.begin(), all.end(), to);
  }

 private:
  bool areNear(const Quaternion& o, float epsilon) const {
    return std::fabs(w - o.w) <= epsilon && std::fabs(x - o.x) <= epsilon &&
           std::fabs(y - o.y) <= epsilon && std::fabs(z - o.z) <= epsilon;
  }
};

/// A point turned, by a quaternion of norm 1.
inline Position3D operator*(const Quaternion& turn, const Position3D& p) {
  const Position3D axis(turn.x, turn.y, turn.z);
  const Position3D side = axis.crossProduct(p) * 2.0f;
  return p + side * turn.w + axis.crossProduct(side);
}

inline float norm(const Quaternion& quaternion) { return quaternion.norm(); }
inline Quaternion normalize(const Quaternion& quaternion) { return quaternion.normalize(); }
inline Quaternion quaternionInverse(const Quaternion& quaternion) { return quaternion.inverse(); }
inline void quaternionInverse(const Quaternion& quaternion, Quaternion& inverse) {
  inverse = quaternion.inverse();
}
inline Quaternion quaternionFromAngleAndAxisRotation(float angle, float ux, float uy, float uz) {
  return Quaternion::fromAngleAndAxisRotation(angle, ux, uy, uz);
}
/// The angle, from 0 to 2 pi [rad], and the unit vector of the axis; one that turns nothing has x.
/// @throws std::runtime_error for 0
inline void angleAndAxisRotationFromQuaternion(const Quaternion& quaternion, float& angle,
                                               float& ux, float& uy, float& uz) {
  const Quaternion q = quaternion.normalize();
  const float length = Position3D(q.x, q.y, q.z).norm();
  angle = 2 * std::atan2(length, q.w);
  ux = length > 0 ? q.x / length : 1;
  uy = length > 0 ? q.y / length : 0;
  uz = length > 0 ? q.z / length : 0;
}
/// The same as four numbers: angle, ux, uy, uz.
inline std::vector<float> angleAndAxisRotationFromQuaternion(const Quaternion& quaternion) {
  std::vector<float> all(4);
  angleAndAxisRotationFromQuaternion(quaternion, all[0], all[1], all[2], all[3]);
  return all;
}

}  // namespace Math
}  // namespace AL
