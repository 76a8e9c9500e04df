#pragma once

#include <vector>

#include <almath/types/alvectorspace.h>

namespace AL {
namespace Math {

/// A velocity [m/s].
struct Velocity3D : detail::VectorSpace<Velocity3D, 3> {
  float xd;
  float yd;
  float zd;

  Velocity3D() : xd(0), yd(0), zd(0) {}
  explicit Velocity3D(float all) : xd(all), yd(all), zd(all) {}
  Velocity3D(float its_xd, float its_yd, float its_zd) : xd(its_xd), yd(its_yd), zd(its_zd) {}
  /// @throws std::runtime_error unless there are 3 numbers.
  explicit Velocity3D(const std::vector<float>& numbers) { read(numbers); }

  /// All numbers divided by norm(). @throws std::runtime_error for 0
  Velocity3D normalize() const { return *this / norm(); }

  static float Velocity3D::*field(int i) {
    static float Velocity3D::*const kFields[] = {&Velocity3D::xd, &Velocity3D::yd, &Velocity3D::zd};
    return kFields[i];
  }
};

inline float norm(const Velocity3D& v) { return v.norm(); }
inline Velocity3D normalize(const Velocity3D& v) { return v.normalize(); }

}  // namespace Math
}  // namespace AL
