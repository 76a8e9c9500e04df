#pragma once

#include <vector>

#include <almath/types/alvectorspace.h>

namespace AL {
namespace Math {

/// Turns about the fixed axes x, then y, then z [rad].
struct Rotation3D : detail::VectorSpace<Rotation3D, 3> {
  float wx;
  float wy;
  float wz;

  Rotation3D() : wx(0), wy(0), wz(0) {}
  explicit Rotation3D(float all) : wx(all), wy(all), wz(all) {}
  Rotation3D(float its_wx, float its_wy, float its_wz) : wx(its_wx), wy(its_wy), wz(its_wz) {}
  /// @throws std::runtime_error unless there are 3 numbers.
  explicit Rotation3D(const std::vector<float>& numbers) { read(numbers); }

  static float Rotation3D::*field(int i) {
    static float Rotation3D::*const kFields[] = {&Rotation3D::wx, &Rotation3D::wy, &Rotation3D::wz};
    return kFields[i];
  }
};

inline float norm(const Rotation3D& turns) { return turns.norm(); }

}  // namespace Math
}  // namespace AL
