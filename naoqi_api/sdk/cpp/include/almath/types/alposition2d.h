#pragma once

#include <vector>

#include <almath/types/alvectorspace.h>

namespace AL {
namespace Math {

/// A point in the plane [m].
struct Position2D : detail::VectorSpace<Position2D, 2> {
  float x;
  float y;

  Position2D() : x(0), y(0) {}
  explicit Position2D(float all) : x(all), y(all) {}
  Position2D(float its_x, float its_y) : x(its_x), y(its_y) {}
  /// @throws std::runtime_error unless there are 2 numbers.
  explicit Position2D(const std::vector<float>& numbers) { read(numbers); }

  static Position2D fromPolarCoordinates(float radius, float angle) {
    return Position2D(radius * std::cos(angle), radius * std::sin(angle));
  }
  float dotProduct(const Position2D& other) const { return x * other.x + y * other.y; }
  float crossProduct(const Position2D& other) const { return x * other.y - y * other.x; }
  float getAngle() const { return std::atan2(y, x); }
  /// @throws std::runtime_error for a vector without length.
  Position2D normalize() const { return *this / norm(); }
  float distanceSquared(const Position2D& other) const {
    return (*this - other).dotProduct(*this - other);
  }
  float distance(const Position2D& other) const { return (*this - other).norm(); }

  static float Position2D::*field(int i) {
    static float Position2D::*const kFields[] = {&Position2D::x, &Position2D::y};
    return kFields[i];
  }
};

inline float norm(const Position2D& p) { return p.norm(); }
inline Position2D normalize(const Position2D& p) { return p.normalize(); }
inline float distance(const Position2D& a, const Position2D& b) { return a.distance(b); }
inline float distanceSquared(const Position2D& a, const Position2D& b) {
  return a.distanceSquared(b);
}
inline float dotProduct(const Position2D& a, const Position2D& b) { return a.dotProduct(b); }
inline float crossProduct(const Position2D& a, const Position2D& b) { return a.crossProduct(b); }
inline void crossProduct(const Position2D& a, const Position2D& b, float& product) {
  product = a.crossProduct(b);
}

}  // namespace Math
}  // namespace AL
