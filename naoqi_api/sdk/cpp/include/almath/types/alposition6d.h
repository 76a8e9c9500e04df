#pragma once

#include <vector>

#include <almath/types/alvectorspace.h>

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

  float distanceSquared(const Position6D& other) const {
    const float dx = x - other.x;
    const float dy = y - other.y;
    const float dz = z - other.z;
    return dx * dx + dy * dy + dz * dz;
  }
  float distance(const Position6D& other) const { return std::sqrt(distanceSquared(other)); }

  static float Position6D::*field(int i) {
    static float Position6D::*const kFields[] = {&Position6D::x,  &Position6D::y,  &Position6D::z,
                                                 &Position6D::wx, &Position6D::wy, &Position6D::wz};
    return kFields[i];
  }
};

}  // namespace Math
}  // namespace AL
