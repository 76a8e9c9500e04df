#pragma once

#include <optional>

#include "camera/image.h"
#include "core/frames.h"

namespace nao::camera {

/// An ideal lens: a point (x, y, z) of the camera frame (x along the line of sight, y left, z up)
/// falls on u = cx - fx y / x, v = cy - fy z / x, in pixels from the upper left corner.
struct Pinhole {
  ImageSize size;
  double fx = 0;  // [px]
  double fy = 0;  // [px]
  double cx = 0;  // [px]
  double cy = 0;  // [px]

  /// Where a point of the camera frame falls; nothing when it is not in front of the camera.
  std::optional<Eigen::Vector2d> project(const Vec3& p_C) const;
};

/// The lens that shows `hfov` by `vfov` [rad] on a picture of this size.
Pinhole makePinhole(double hfov, double vfov, ImageSize size);

}  // namespace nao::camera
