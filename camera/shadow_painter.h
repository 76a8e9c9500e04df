#pragma once

#include "camera/ground_painter.h"
#include "core/shape.h"

namespace nao::camera {

/// The soft shadow on the ground below something near it: an ellipse, darkest in its middle.
struct Shadow {
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();      // [m] in W
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  // of its length, unit
  double half_length = 0;                                // [m]
  double half_width = 0;                                 // [m]
  double darkness = 0;                                   // 0 to 1, in its middle
};

/// The shadow of a shape at this place; darkness 0 if it hangs too high to have one.
Shadow shadowOf(const Shape& shape, const Pose& X_WS);

/// Darkens the ground; for pictures on which nothing but the ground is painted.
void paintShadow(const Shadow& shadow, const GroundForms& ground, Raster& raster);

}  // namespace nao::camera
