#pragma once

#include <array>
#include <vector>

#include "camera/ground_painter.h"
#include "camera/raster.h"
#include "camera/view.h"
#include "core/texture.h"

namespace nao::camera {

/// A corner of a triangle in the camera frame, with the light that falls on it.
struct LitCorner {
  Vec3 p_C = Vec3::Zero();
  double light = 0;                                   // 0 to 256
  Eigen::Vector2d texture = Eigen::Vector2d::Zero();  // 0 to 1: right, down
};

/// What triangles are painted with.
struct Paint {
  Pixel color = 0;
  const Texture* texture = nullptr;  // in place of the colour
  bool is_above_ground = false;      // all of it, so the ground needs no look
  Thing thing = kGround;
};

/// Where a corner falls on the picture; texture and light are as on the corner, over depth.
struct ScreenCorner {
  double u = 0;
  double v = 0;
  double inverse_depth = 0;  // [1/m]
  double light = 0;
  Eigen::Vector2d texture_over_depth = Eigen::Vector2d::Zero();
};

/// Fills triangles into a raster: nearest wins, nothing shows through the ground. What is nearer
/// than the near plane is cut off. Textures are true to perspective, each pixel from the level
/// whose pixels are as large as itself; light is interpolated on the picture.
class TrianglePainter {
 public:
  TrianglePainter(const Pinhole& lens, const LinearForm& ground_inverse_depth, Raster& raster)
      : lens_(lens), ground_(ground_inverse_depth), raster_(raster) {}

  void use(const Paint& paint) { paint_ = paint; }

  /// Of a corner beyond the near plane.
  ScreenCorner project(const LitCorner& corner) const;

  /// Paints the triangle unless it is seen from behind (its corners run clockwise); whether it is
  /// seen from the front.
  bool paint(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c);

  /// The same for corners of which some may be nearer than the near plane.
  void paintClipped(const std::array<LitCorner, 3>& corners);

 private:
  struct Surface {
    LinearForm inverse_depth;
    LinearForm light;
    LinearForm right;  // on the texture, over depth
    LinearForm down;
    Pixel color = 0;
    bool is_flat = false;
  };

  void fill(const Surface& surface, std::array<const ScreenCorner*, 3> corners);
  void fillRow(const Surface& surface, int row, double left, double right);
  void texture(const Surface& surface, int row, int first, int end);

  const Pinhole& lens_;
  LinearForm ground_;
  Raster& raster_;
  Paint paint_;
};

/// Part of the outline of a solid, or of a border between its faces.
struct SoftEdge {
  double u[2] = {0, 0};
  double v[2] = {0, 0};
  double inverse_depth[2] = {0, 0};
};

/// Mixes the two sides of an edge where pixels lie on both, each by the part it covers, unless
/// something nearer hides the edge. For pictures on which everything is painted.
void soften(const SoftEdge& edge, const LinearForm& ground_inverse_depth, Raster& raster);

}  // namespace nao::camera
