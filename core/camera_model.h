#pragma once

#include <string>
#include <vector>

#include "core/frames.h"
#include "core/sim_time.h"

namespace nao {

/// How a lens departs from a pinhole ("plumb bob"): a point that a pinhole shows at (x, y), in
/// focal lengths from the middle, right and down, is shown at
///   x (1 + k1 r^2 + k2 r^4) + 2 p1 x y + p2 (r^2 + 2 x^2),  r^2 = x^2 + y^2
///   y (1 + k1 r^2 + k2 r^4) + p1 (r^2 + 2 y^2) + 2 p2 x y
struct LensDistortion {
  double k1 = 0;
  double k2 = 0;
  double p1 = 0;
  double p2 = 0;
};

/// Which of a camera's imperfections are on.
struct CameraEffects {
  bool response = false;  // exposure, gain, white balance, colours as its sensor has them
  bool noise = false;
  bool vignetting = false;
  bool distortion = false;
  bool motion_blur = false;
  bool rolling_shutter = false;
};

struct CameraModel {
  std::string name;  // CameraTop, CameraBottom
  int body = 0;
  Pose X_BC = Pose::Identity();  // x along the line of sight
  double hfov = 0;               // [rad]
  double vfov = 0;               // [rad]
  int max_width = 640;           // [px]
  int max_height = 480;          // [px]
  std::vector<int> frame_rates;  // [1/s] offered, ascending; a wish is rounded up
  std::string sensor;            // OV7670, MT9M114, OV5640; empty: by the robot's version
  LensDistortion distortion;
  CameraEffects effects;
  Duration latency{};  // from what a picture shows to when it is handed out
};

}  // namespace nao
