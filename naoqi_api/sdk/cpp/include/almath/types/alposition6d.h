#pragma once

#include <vector>

#include <almath/types/alvectorspace.h>
#include <almath/types/alvelocity6d.h>

namespace AL {
namespace Math {

/// A point [m] and turns about the fixed axes x, then y, then z [rad].
struct Position6D : detail::VectorSpace<Position6D, 6> {
  float x;
  float y;
  float z;
  float wx;
  float wy;
  float wz;

  Position6D() : x(0), y(0), z(0), wx(0), wy(0), wz(0) {}
  explicit Position6D(float all) : x(all), y(all), z(all), wx(all), wy(all), wz(all) {}
  Position6D(float its_x, float its_y, float its_z, float its_wx, float its_wy, float its_wz)
      : x(its_x), y(its_y), z(its_z), wx(its_wx), wy(its_wy), wz(its_wz) {}
  /// @throws std::runtime_error unless there are 6 numbers.
  explicit Position6D(const std::vector<float>& numbers) { read(numbers); }

  /// Between the points alone, as distance() is [m].
  float distanceSquared(const Position6D& other) const {
    const float dx = x - other.x;
    const float dy = y - other.y;
    const float dz = z - other.z;
    return dx * dx + dy * dy + dz * dz;
  }
  float distance(const Position6D& other) const { return std::sqrt(distanceSquared(other)); }
  /// All six numbers divided by norm(). @throws std::runtime_error for 0
  Position6D normalize() const { return *this / norm(); }

  static float Position6D::*field(int i) {
    static float Position6D::*const kFields[] = {&Position6D::x,  &Position6D::y,  &Position6D::z,
                                                 &Position6D::wx, &Position6D::wy, &Position6D::wz};
    return kFields[i];
  }
};

/// A way and a rate [1/s] make a velocity, from this side alone: p * 2 is a position.
inline Velocity6D operator*(float rate, const Position6D& p) {
  return Velocity6D(rate * p.x, rate * p.y, rate * p.z, rate * p.wx, rate * p.wy, rate * p.wz);
}

inline float norm(const Position6D& p) { return p.norm(); }
inline Position6D normalize(const Position6D& p) { return p.normalize(); }
inline float distance(const Position6D& a, const Position6D& b) { return a.distance(b); }
inline float distanceSquared(const Position6D& a, const Position6D& b) {
  return a.distanceSquared(b);
}

}  // namespace Math
}  // namespace AL
