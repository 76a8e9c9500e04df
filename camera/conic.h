#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

namespace nao::camera {

/// A quantity that is linear over the picture: u * column + v * row + one.
struct LinearForm {
  double u = 0;
  double v = 0;
  double one = 0;

  double at(double column, double row) const { return u * column + v * row + one; }
};

inline LinearForm operator+(const LinearForm& a, const LinearForm& b) {
  return {a.u + b.u, a.v + b.v, a.one + b.one};
}
inline LinearForm operator-(const LinearForm& a, const LinearForm& b) {
  return {a.u - b.u, a.v - b.v, a.one - b.one};
}
inline LinearForm operator*(double s, const LinearForm& a) { return {s * a.u, s * a.v, s * a.one}; }

/// The part of a pixel that lies on the positive side of an edge `distance` [px] away.
inline double coverage(double distance) { return std::clamp(distance + 0.5, 0.0, 1.0); }

/// Columns (real numbers) between which something lies.
struct Interval {
  double low = 0;
  double high = 0;
};

/// A quadratic over the picture, negative inside: what circles on the ground and spheres look
/// like through a pinhole. Sums of products of linear forms.
class Conic {
 public:
  /// Adds s * a * a.
  void addSquare(double s, const LinearForm& a) {
    uu_ += s * a.u * a.u;
    uv_ += s * 2 * a.u * a.v;
    vv_ += s * a.v * a.v;
    u_ += s * 2 * a.u * a.one;
    v_ += s * 2 * a.v * a.one;
    one_ += s * a.one * a.one;
  }

  double at(double u, double v) const {
    return (uu_ * u + uv_ * v + u_) * u + (vv_ * v + v_) * v + one_;
  }

  /// Distance to the outline [px], positive inside; to first order, so good near the outline.
  double insideDistance(double u, double v) const {
    const double du = 2 * uu_ * u + uv_ * v + u_;
    const double dv = uv_ * u + 2 * vv_ * v + v_;
    return -at(u, v) / (std::sqrt(du * du + dv * dv) + 1e-30);
  }

  /// Whether each row runs inside between two columns; else it does so at its far ends.
  bool isBounded() const { return uu_ > 0; }

  /// Where row v runs inside. Nothing: nowhere. A row that is inside at both far ends (the outline
  /// is a hyperbola) counts as inside everywhere.
  std::optional<Interval> rowInside(double v) const {
    const double b = uv_ * v + u_;
    const double c = (vv_ * v + v_) * v + one_;
    if (!isBounded()) return Interval{-1e9, 1e9};
    const double discriminant = b * b - 4 * uu_ * c;
    if (discriminant <= 0) return std::nullopt;
    const double root = std::sqrt(discriminant);
    return Interval{(-b - root) / (2 * uu_), (-b + root) / (2 * uu_)};
  }

  /// The columns that row `row` (its whole height) may touch, with a pixel to spare.
  std::optional<Interval> rowReach(int row) const {
    std::optional<Interval> reach;
    for (const double v : {row - 0.25, row + 0.5, row + 1.25}) {
      const std::optional<Interval> inside = rowInside(v);
      if (!inside) continue;
      if (!reach) reach = inside;
      reach->low = std::min(reach->low, inside->low - 1);
      reach->high = std::max(reach->high, inside->high + 1);
    }
    return reach;
  }

 private:
  double uu_ = 0, uv_ = 0, vv_ = 0, u_ = 0, v_ = 0, one_ = 0;
};

}  // namespace nao::camera
