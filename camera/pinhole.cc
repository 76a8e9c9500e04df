#include "camera/pinhole.h"

namespace nao::camera {
namespace {

/// tan for |x| < 1.2, by the quotient of two power series: the C library's own picks its way by
/// the CPU at hand, and a picture must be the same on all of them.
double portableTan(double x) {
  double sine = 0;
  double cosine = 0;
  double term = 1;  // x^k / k!, with the sign of the series
  for (int k = 0; k < 24; k += 2) {
    cosine += term;
    term *= x / (k + 1);
    sine += term;
    term *= -x / (k + 2);
  }
  return sine / cosine;
}

}  // namespace

std::optional<Eigen::Vector2d> Pinhole::project(const Vec3& p_C) const {
  if (p_C.x() <= 0) return std::nullopt;
  return Eigen::Vector2d(cx - fx * p_C.y() / p_C.x(), cy - fy * p_C.z() / p_C.x());
}

Pinhole makePinhole(double hfov, double vfov, ImageSize size) {
  Pinhole lens;
  lens.size = size;
  lens.cx = size.width / 2.0;
  lens.cy = size.height / 2.0;
  lens.fx = lens.cx / portableTan(hfov / 2);
  lens.fy = lens.cy / portableTan(vfov / 2);
  return lens;
}

}  // namespace nao::camera
