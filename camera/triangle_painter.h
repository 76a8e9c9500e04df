#pragma once

#include <array>

#include "camera/ground_painter.h"
#include "camera/raster.h"
#include "camera/view.h"

namespace nao::camera {

/// A corner of a triangle in the camera frame, with the light that falls on it.
struct LitCorner {
  Vec3 p_C = Vec3::Zero();
  double light = 0;  // 0 to 256
};

/// Fills triangles into a raster: nearest wins, nothing shows through the ground. What is nearer
/// than the near plane is cut off; light is interpolated in space, not on the picture.
class TrianglePainter {
 public:
  TrianglePainter(const Pinhole& lens, const LinearForm& ground_inverse_depth, Raster& raster)
      : lens_(lens), ground_(ground_inverse_depth), raster_(raster) {}

  /// Paints the triangle unless it is seen from behind (its corners run clockwise).
  void paint(const std::array<LitCorner, 3>& corners, Pixel color);

 private:
  struct ScreenCorner {
    double u = 0;
    double v = 0;
    double inverse_depth = 0;  // [1/m]
    double light_over_depth = 0;
  };
  struct Surface {
    LinearForm inverse_depth;
    LinearForm light_over_depth;
    Pixel color = 0;
    bool flat = false;
  };

  ScreenCorner project(const LitCorner& corner) const;
  void paintOnScreen(std::array<ScreenCorner, 3> corners, Pixel color, bool flat, double light);
  void fill(std::array<ScreenCorner, 3> corners, const Surface& surface);
  void fillRow(int row, double left, double right, const Surface& surface);

  const Pinhole& lens_;
  LinearForm ground_;
  Raster& raster_;
};

}  // namespace nao::camera
