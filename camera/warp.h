#pragma once

#include <vector>

#include "camera/raster.h"
#include "camera/view.h"
#include "core/camera_model.h"

namespace nao::camera {

/// How a camera turns while it takes a picture: row by row, each over the time of its exposure.
struct Turning {
  Vec3 w_WC_C = Vec3::Zero();  // [rad/s] of the camera, in its own axes
  double readout = 0;          // [s] from the first row to the last; 0: all at once
  double exposure = 0;         // [s] over which a row is blurred; 0: not at all
};

/// Makes the picture that a real lens throws on rows read one after the other, from a pinhole's
/// picture that shows somewhat more. What moves is the camera, about its own place; the scene is
/// that of the first row's time.
class Warp {
 public:
  explicit Warp(const LensDistortion& lens) : lens_(lens) {}

  /// The pinhole picture that warped() needs for a picture through `view`.
  View wideView(const View& view, const Turning& turning);

  /// Good until the next call.
  Raster& warped(const Raster& wide, const View& view, const View& wide_view,
                 const Turning& turning);

  /// Where the lens shows a point of the camera frame in front of it.
  Eigen::Vector2d project(const Pinhole& pinhole, const Vec3& p_C) const;

 private:
  struct Ray {
    float right, down;  // of the pinhole's ray, in focal lengths
  };
  void findRays(const Pinhole& lens);
  Eigen::Vector2d distorted(const Eigen::Vector2d& ideal) const;
  Eigen::Vector2d undistorted(const Eigen::Vector2d& shown) const;
  void warpRow(const Raster& wide, const Pinhole& lens, const Pinhole& wide_lens,
               const Turning& turning, int row);

  LensDistortion lens_;
  Pinhole rays_of_;
  std::vector<Ray> rays_;  // by pixel
  std::vector<std::array<int, 3>> sums_;
  Raster picture_;
};

}  // namespace nao::camera
