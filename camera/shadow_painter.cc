#include "camera/shadow_painter.h"

#include <cmath>

#include "camera/mesh.h"

namespace nao::camera {
namespace {

// In a hall lit from many lamps only what is near the ground has a shadow worth the name. Free
// choices, by eye.
constexpr double kReach = 0.12;   // [m] above this there is none
constexpr double kDarkest = 0.6;  // part of the light taken away below what lies on the ground
constexpr double kSpread = 1.35;  // of the shadow's outline over the shape's

/// Half of what a shape measures along the axes of its own frame.
Vec3 halfExtents(const Shape& shape) {
  const double radius = shape.size.x();
  switch (shape.kind) {
    case Shape::Kind::Box:
    case Shape::Kind::Hull:
      return shape.size / 2;
    case Shape::Kind::Sphere:
      return Vec3::Constant(radius);
    case Shape::Kind::Cylinder:
      return {radius, radius, shape.size.z() / 2};
    case Shape::Kind::Capsule:
      return {radius, radius, shape.size.z() / 2 + radius};
  }
  return Vec3::Zero();
}

}  // namespace

Shadow shadowOf(const Shape& shape, const Pose& X_WS) {
  const Vec3 half = halfExtents(shape);
  const Mat3 R_WS = X_WS.linear();
  const double below = (R_WS.row(2).transpose().cwiseAbs()).dot(half);
  const double gap = std::max(0.0, X_WS.translation().z() - below);
  Shadow shadow;
  if (!(gap < kReach) || X_WS.translation().z() < 0) return shadow;
  // Along the axis that lies flattest on the ground and reaches farthest there.
  Eigen::Vector2d longest = Eigen::Vector2d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector2d reach = half[i] * R_WS.col(i).head<2>();
    if (reach.squaredNorm() > longest.squaredNorm()) longest = reach;
  }
  const double length = std::sqrt(longest.squaredNorm());
  if (!(length > 0)) return shadow;
  shadow.centre = X_WS.translation().head<2>();
  shadow.direction = longest / length;
  double width = 0;
  const Eigen::Vector2d across(-shadow.direction.y(), shadow.direction.x());
  for (int i = 0; i < 3; ++i) width += std::abs(half[i] * across.dot(R_WS.col(i).head<2>()));
  const double spread = kSpread + gap / kReach;
  shadow.half_length = spread * length;
  shadow.half_width = spread * std::min(width, length);
  shadow.darkness = kDarkest * (1 - gap / kReach) * (1 - gap / kReach);
  return shadow;
}

void paintShadow(const Shadow& shadow, const GroundForms& ground, Raster& raster) {
  const LinearForm x = ground.x - shadow.centre.x() * ground.fall;
  const LinearForm y = ground.y - shadow.centre.y() * ground.fall;
  const auto [c, s] = std::pair(shadow.direction.x(), shadow.direction.y());
  const LinearForm along = (1 / shadow.half_length) * (c * x + s * y);
  const LinearForm across = (1 / shadow.half_width) * (c * y - s * x);
  Conic outline;
  outline.addSquare(1, along);
  outline.addSquare(1, across);
  outline.addSquare(-1, ground.fall);
  const ImageSize size = raster.size();
  for (int row = 0; row < size.height; ++row) {
    const std::optional<Interval> inside = outline.rowInside(row + 0.5);
    if (!inside) continue;
    const int first = static_cast<int>(std::clamp(inside->low, 0.0, double(size.width)));
    const int end = static_cast<int>(std::clamp(inside->high + 1, 0.0, double(size.width)));
    Pixel* const colors = raster.colors(row);
    for (int i = first; i < end; ++i) {
      const double fall = ground.fall.at(i + 0.5, row + 0.5);
      if (fall <= 0) continue;
      const double far = along.at(i + 0.5, row + 0.5), side = across.at(i + 0.5, row + 0.5);
      const double light = 1 - (far * far + side * side) / (fall * fall);  // 0 at the outline
      if (light <= 0) continue;
      colors[i] = lit(colors[i], static_cast<int>(256 * (1 - shadow.darkness * light)));
    }
  }
}

}  // namespace nao::camera
