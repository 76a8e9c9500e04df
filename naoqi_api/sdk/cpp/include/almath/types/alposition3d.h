#pragma once

#include <vector>

#include <almath/types/alvectorspace.h>
#include <almath/types/alvelocity3d.h>

namespace AL {
namespace Math {

/// A point in space [m].
struct Position3D : detail::VectorSpace<Position3D, 3> {
  float x;
  float y;
  float z;

  Position3D() : x(0), y(0), z(0) {}
  explicit Position3D(float all) : x(all), y(all), z(all) {}
  Position3D(float its_x, float its_y, float its_z) : x(its_x), y(its_y), z(its_z) {}
  /// @throws std::runtime_error unless there are 3 numbers.
  explicit Position3D(const std::vector<float>& numbers) { read(numbers); }

  float dotProduct(const Position3D& other) const {
    return x * other.x + y * other.y + z * other.z;
  }
  Position3D crossProduct(const Position3D& other) const {
    return Position3D(y * other.z - z * other.y, z * other.x - x * other.z,
                      x * other.y - y * other.x);
  }
  /// @throws std::runtime_error for a vector without length.
  Position3D normalize() const { return *this / norm(); }
  bool isUnitVector(float epsilon = 0.0001f) const { return std::fabs(norm() - 1) <= epsilon; }
  /// Whether the product of both is 0, within `epsilon`.
  bool isOrthogonal(const Position3D& other, float epsilon = 0.0001f) const {
    return std::fabs(dotProduct(other)) <= epsilon;
  }
  float distanceSquared(const Position3D& other) const {
    return (*this - other).dotProduct(*this - other);
  }
  float distance(const Position3D& other) const { return (*this - other).norm(); }

  static float Position3D::*field(int i) {
    static float Position3D::*const kFields[] = {&Position3D::x, &Position3D::y, &Position3D::z};
    return kFields[i];
  }
};

/// A way and a rate [1/s] make a velocity, from this side alone: p * 2 is a position.
inline Velocity3D operator*(float rate, const Position3D& p) {
  return Velocity3D(rate * p.x, rate * p.y, rate * p.z);
}

inline float norm(const Position3D& p) { return p.norm(); }
inline Position3D normalize(const Position3D& p) { return p.normalize(); }
inline bool isUnitVector(const Position3D& p, float epsilon = 0.0001f) {
  return p.isUnitVector(epsilon);
}
inline bool isOrthogonal(const Position3D& a, const Position3D& b, float epsilon = 0.0001f) {
  return a.isOrthogonal(b, epsilon);
}
inline float distance(const Position3D& a, const Position3D& b) { return a.distance(b); }
inline float distanceSquared(const Position3D& a, const Position3D& b) {
  return a.distanceSquared(b);
}
inline float dotProduct(const Position3D& a, const Position3D& b) { return a.dotProduct(b); }
inline Position3D crossProduct(const Position3D& a, const Position3D& b) {
  return a.crossProduct(b);
}

}  // namespace Math
}  // namespace AL
