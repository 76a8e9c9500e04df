#pragma once

#include <vector>

#include <almath/types/alvectorspace.h>

namespace AL {
namespace Math {

/// A velocity [m/s] and turning velocity [rad/s].
struct Velocity6D : detail::VectorSpace<Velocity6D, 6> {
  float xd;
  float yd;
  float zd;
  float wxd;
  float wyd;
  float wzd;

  Velocity6D() : xd(0), yd(0), zd(0), wxd(0), wyd(0), wzd(0) {}
  explicit Velocity6D(float all) : xd(all), yd(all), zd(all), wxd(all), wyd(all), wzd(all) {}
  Velocity6D(float its_xd, float its_yd, float its_zd, float its_wxd, float its_wyd, float its_wzd)
      : xd(its_xd), yd(its_yd), zd(its_zd), wxd(its_wxd), wyd(its_wyd), wzd(its_wzd) {}
  /// @throws std::runtime_error unless there are 6 numbers.
  explicit Velocity6D(const std::vector<float>& numbers) { read(numbers); }

  /// All numbers divided by norm(). @throws std::runtime_error for 0
  Velocity6D normalize() const { return *this / norm(); }

  static float Velocity6D::*field(int i) {
    static float Velocity6D::*const kFields[] = {&Velocity6D::xd,  &Velocity6D::yd,
                                                 &Velocity6D::zd,  &Velocity6D::wxd,
                                                 &Velocity6D::wyd, &Velocity6D::wzd};
    return kFields[i];
  }
};

inline float norm(const Velocity6D& v) { return v.norm(); }
inline Velocity6D normalize(const Velocity6D& v) { return v.normalize(); }

}  // namespace Math
}  // namespace AL
