#pragma once

#include "camera/conic.h"
#include "camera/pinhole.h"
#include "core/frames.h"

namespace nao::camera {

/// From where, and through what, a picture is taken.
struct View {
  Pose X_WC = Pose::Identity();
  Pinhole lens;
};

/// Solids nearer than this are cut off [m].
inline constexpr double kNearPlane = 0.01;

/// The ray through a pixel is d_C = (1, left, up), so depth is measured along the line of sight.
struct RayForms {
  LinearForm left;
  LinearForm up;
};

inline RayForms rayForms(const Pinhole& lens) {
  return {{-1 / lens.fx, 0, lens.cx / lens.fx}, {0, -1 / lens.fy, lens.cy / lens.fy}};
}

/// The component along `axis_C` of the ray through each pixel.
inline LinearForm alongRay(const RayForms& ray, const Vec3& axis_C) {
  return LinearForm{0, 0, axis_C.x()} + axis_C.y() * ray.left + axis_C.z() * ray.up;
}

}  // namespace nao::camera
