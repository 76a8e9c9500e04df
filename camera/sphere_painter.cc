#include "camera/sphere_painter.h"

#include "camera/light.h"

namespace nao::camera {
namespace {

// The ray d through a pixel hits the sphere c, r where |t d - c| = r:
//   t = (d.c - sqrt((d.c)^2 - |d|^2 k)) / |d|^2  with  k = |c|^2 - r^2
// and the outline is where the root vanishes.
struct Painter {
  const SphereInView& sphere;
  const Vec3& lamp_C;
  const LinearForm& ground;
  RayForms ray;
  LinearForm towards;  // d.c
  Conic outline;
  double k = 0;
  double largest_weight = 0;

  void paintPixel(int column, int row, Raster& raster) const {
    const double u = column + 0.5;
    const double v = row + 0.5;
    const int weight =
        static_cast<int>(largest_weight * coverage(outline.insideDistance(u, v)) + 0.5);
    const double dc = towards.at(u, v);
    if (weight == 0 || dc <= 0) return;
    const Vec3 d(1, ray.left.at(u, v), ray.up.at(u, v));
    const double dd = d.squaredNorm();
    const double depth = (dc - std::sqrt(std::max(0.0, dc * dc - dd * k))) / dd;
    if (depth < kNearPlane) return;
    float& behind = raster.inverseDepths(row)[column];
    const float nearness = static_cast<float>(1 / depth);
    if (nearness <= behind || 1 / depth <= ground.at(u, v)) return;
    const Vec3 normal = (depth * d - sphere.p_C) / sphere.radius;
    const Pixel paint =
        lit(sphere.color, static_cast<int>(lightStrength(std::min(1.0, normal.dot(lamp_C)))));
    Pixel& color = raster.colors(row)[column];
    color = blend(color, paint, weight);
    if (weight >= 128) behind = nearness;
  }
};

}  // namespace

void paintSphere(const SphereInView& sphere, const Pinhole& lens, const Vec3& lamp_C,
                 const LinearForm& ground_inverse_depth, Raster& raster) {
  Painter painter{sphere, lamp_C, ground_inverse_depth, rayForms(lens), {}, {}};
  painter.k = sphere.p_C.squaredNorm() - sphere.radius * sphere.radius;
  if (painter.k <= 0 || sphere.p_C.x() + sphere.radius < kNearPlane) return;
  painter.towards = alongRay(painter.ray, sphere.p_C);
  painter.outline.addSquare(painter.k, {0, 0, 1});
  painter.outline.addSquare(painter.k, painter.ray.left);
  painter.outline.addSquare(painter.k, painter.ray.up);
  painter.outline.addSquare(-1, painter.towards);
  // A sphere smaller than a pixel can not cover one.
  const double area = 3.1416 * lens.fx * lens.fy * sphere.radius * sphere.radius / painter.k;
  painter.largest_weight = 256 * std::min(1.0, area);
  const double width = raster.size().width;
  for (int row = 0; row < raster.size().height; ++row) {
    const std::optional<Interval> reach = painter.outline.rowReach(row);
    if (!reach) continue;
    const int end = static_cast<int>(std::clamp(reach->high + 0.5, 0.0, width));
    for (int i = static_cast<int>(std::clamp(reach->low + 0.5, 0.0, width)); i < end; ++i) {
      painter.paintPixel(i, row, raster);
    }
  }
}

}  // namespace nao::camera
