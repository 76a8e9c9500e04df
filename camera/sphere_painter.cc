#include "camera/sphere_painter.h"

#include "camera/light.h"
#include "camera/texture_sampler.h"

namespace nao::camera {
namespace {

constexpr Pixel kPatch = toPixel({25, 25, 25});

// The middles of a soccer ball's twelve patches are an icosahedron's corners, (0, 1, phi) turned
// through its axes, of unit length. A patch is drawn round; twelve of them cover a quarter of the
// ball, as the pentagons of the classic one do (28 %).
constexpr double kShort = 0.5257311121191336;
constexpr double kLong = 0.8506508083520399;
constexpr double kPatchCosine = 0.9528;  // 1 - 0.283 / 6, of a patch's half angle
constexpr double kPatchSine = 0.3036;

/// The part of a pixel of this size [rad] that is patch.
double patchCover(const Vec3& normal_S, double pixel) {
  const Vec3 n = normal_S.cwiseAbs();
  const double cosine = std::max({kShort * n.y() + kLong * n.z(), kShort * n.z() + kLong * n.x(),
                                  kShort * n.x() + kLong * n.y()});
  return coverage((cosine - kPatchCosine) / (kPatchSine * pixel));
}

/// The angle of a direction from x, 0 to 2 pi, to 1e-4: the arc tangent by a polynomial
/// (Abramowitz and Stegun, 4.4.49), as the C library's differs between machines.
double angleOf(double x, double y) {
  const double a = std::abs(x), b = std::abs(y);
  const double t = std::min(a, b) / std::max({a, b, 1e-30});
  const double t2 = t * t;
  const double flat =
      t * (0.9998660 + t2 * (-0.3302995 + t2 * (0.1801410 + t2 * (-0.0851330 + t2 * 0.0208351))));
  const double in_quarter = b > a ? M_PI / 2 - flat : flat;
  const double in_half = x < 0 ? M_PI - in_quarter : in_quarter;
  return y < 0 ? 2 * M_PI - in_half : in_half;
}

/// A globe's map: right by longitude from where x comes out, down by latitude from the top.
Pixel mapAt(const Texture& texture, const Vec3& normal_S, double pixel) {
  const double across = std::sqrt(normal_S.x() * normal_S.x() + normal_S.y() * normal_S.y());
  const double down = angleOf(normal_S.z(), across) / M_PI;
  const double right = angleOf(normal_S.x(), normal_S.y()) / (2 * M_PI);
  const Texture::Level& whole = texture.levels.front();
  const double size = pixel * std::max(whole.height / M_PI, whole.width / (2 * M_PI));
  return sampleAt(texture, right, down, size);
}

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
  double focal_length = 0;  // [px]

  int weightAt(double u, double v) const {
    if (sphere.has_hard_rim) return outline.at(u, v) < 0 ? 256 : 0;
    return static_cast<int>(largest_weight * coverage(outline.insideDistance(u, v)) + 0.5);
  }

  Pixel paintAt(const Vec3& normal, double depth) const {
    if (sphere.is_flat) return sphere.color;
    const Pixel color = colorAt(normal, depth);
    return lit(color, static_cast<int>(lightStrength(std::min(1.0, normal.dot(lamp_C)))));
  }

  Pixel colorAt(const Vec3& normal, double depth) const {
    if (!sphere.has_patches && sphere.texture == nullptr) return sphere.color;
    const double pixel = depth / (focal_length * sphere.radius);  // its size on the unit sphere
    const Vec3 normal_S = sphere.R_CS.transpose() * normal;
    if (sphere.texture != nullptr) return mapAt(*sphere.texture, normal_S, pixel);
    const int cover = static_cast<int>(256 * patchCover(normal_S, pixel) + 0.5);
    return blend(sphere.color, kPatch, cover);
  }

  void paintPixel(int column, int row, Raster& raster) const {
    const double u = column + 0.5;
    const double v = row + 0.5;
    const int weight = weightAt(u, v);
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
    Pixel& color = raster.colors(row)[column];
    color = blend(color, paintAt(normal, depth), weight);
    raster.things(row)[column] = weight < 256 ? kRim : sphere.thing;
    if (weight >= 128) behind = nearness;
  }
};

}  // namespace

void paintSphere(const SphereInView& sphere, const Pinhole& lens, const Vec3& lamp_C,
                 const LinearForm& ground_inverse_depth, Raster& raster) {
  Painter painter{sphere, lamp_C, ground_inverse_depth, rayForms(lens), {}, {}};
  painter.focal_length = lens.fx;
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
