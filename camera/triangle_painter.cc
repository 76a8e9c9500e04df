#include "camera/triangle_painter.h"

#include <cmath>

#include "camera/texture_sampler.h"

namespace nao::camera {
namespace {

LitCorner onNearPlane(const LitCorner& a, const LitCorner& b) {
  const double part = (kNearPlane - a.p_C.x()) / (b.p_C.x() - a.p_C.x());
  LitCorner cut{a.p_C + part * (b.p_C - a.p_C), a.light + part * (b.light - a.light),
                a.texture + part * (b.texture - a.texture)};
  cut.p_C.x() = kNearPlane;
  return cut;
}

/// The part of a triangle beyond the near plane: none, three or four corners.
struct Clipped {
  std::array<LitCorner, 4> corners;
  int count = 0;

  void add(const LitCorner& corner) { corners[count++] = corner; }
};

Clipped clipAtNearPlane(const std::array<LitCorner, 3>& corners) {
  Clipped clipped;
  for (int i = 0; i < 3; ++i) {
    const LitCorner& a = corners[i];
    const LitCorner& b = corners[(i + 1) % 3];
    const bool a_visible = a.p_C.x() >= kNearPlane;
    const bool b_visible = b.p_C.x() >= kNearPlane;
    if (a_visible) clipped.add(a);
    if (a_visible && !b_visible) clipped.add(onNearPlane(a, b));
    if (!a_visible && b_visible) clipped.add(onNearPlane(b, a));
  }
  return clipped;
}

/// First pixel whose centre is not left of (above) `edge`, within 0 .. limit.
int firstPixel(double edge, int limit) {
  const double shifted = std::clamp(edge - 0.5, 0.0, static_cast<double>(limit));
  const int whole = static_cast<int>(shifted);
  return whole < shifted ? whole + 1 : whole;
}

/// A side of a triangle, from top to bottom.
struct Side {
  double u, v, slope;

  Side(const ScreenCorner& top, const ScreenCorner& bottom)
      : u(top.u), v(top.v), slope((bottom.u - top.u) / (bottom.v - top.v)) {}
  double at(double row) const { return u + (row - v) * slope; }
};

// From top to bottom; equal heights by u, so that triangles that share an edge cut it alike.
bool isHigher(const ScreenCorner* a, const ScreenCorner* b) {
  return a->v < b->v || (a->v == b->v && a->u < b->u);
}

}  // namespace

ScreenCorner TrianglePainter::project(const LitCorner& corner) const {
  const double inverse = 1 / corner.p_C.x();
  return {lens_.cx - lens_.fx * corner.p_C.y() * inverse,
          lens_.cy - lens_.fy * corner.p_C.z() * inverse, inverse, corner.light,
          inverse * corner.texture};
}

void TrianglePainter::paintClipped(const std::array<LitCorner, 3>& corners) {
  const Clipped clipped = clipAtNearPlane(corners);
  if (clipped.count < 3) return;
  const ScreenCorner first = project(clipped.corners[0]);
  ScreenCorner second = project(clipped.corners[1]);
  for (int i = 2; i < clipped.count; ++i) {
    const ScreenCorner third = project(clipped.corners[i]);
    paint(first, second, third);
    second = third;
  }
}

bool TrianglePainter::paint(const ScreenCorner& a, const ScreenCorner& b, const ScreenCorner& c) {
  const double ab_u = b.u - a.u, ab_v = b.v - a.v, ac_u = c.u - a.u, ac_v = c.v - a.v;
  // v counts downwards, so a front face, counter-clockwise to the eye, has a negative area.
  const double area = ab_u * ac_v - ac_u * ab_v;
  if (!(area < 0)) return false;
  const double inverse_area = 1 / area;
  // The linear form that takes the corners' values at the corners.
  const auto through = [&](double at_a, double at_b, double at_c) {
    const double ab = at_b - at_a, ac = at_c - at_a;
    const double du = (ab * ac_v - ac * ab_v) * inverse_area;
    const double dv = (ac * ab_u - ab * ac_u) * inverse_area;
    return LinearForm{du, dv, at_a - du * a.u - dv * a.v};
  };
  Surface surface;
  surface.inverse_depth = through(a.inverse_depth, b.inverse_depth, c.inverse_depth);
  surface.is_flat = a.light == b.light && a.light == c.light;
  surface.color = surface.is_flat ? lit(paint_.color, static_cast<int>(a.light)) : paint_.color;
  if (!surface.is_flat || paint_.texture) surface.light = through(a.light, b.light, c.light);
  if (paint_.texture) {
    const auto &at = a.texture_over_depth, &bt = b.texture_over_depth, &ct = c.texture_over_depth;
    surface.right = through(at.x(), bt.x(), ct.x());
    surface.down = through(at.y(), bt.y(), ct.y());
  }
  fill(surface, {&a, &b, &c});
  return true;
}

void TrianglePainter::fill(const Surface& surface, std::array<const ScreenCorner*, 3> corners) {
  std::sort(corners.begin(), corners.end(), isHigher);
  const auto& [top, middle, bottom] = corners;
  const int height = raster_.size().height;
  const int first = firstPixel(top->v, height);
  const int turn = firstPixel(middle->v, height);
  const int end = firstPixel(bottom->v, height);
  if (first == end) return;
  const Side whole(*top, *bottom);
  const auto fillRows = [&](const Side& side, int from, int to) {
    for (int row = from; row < to; ++row) {
      const double a = whole.at(row + 0.5);
      const double b = side.at(row + 0.5);
      fillRow(surface, row, std::min(a, b), std::max(a, b));
    }
  };
  if (first < turn) fillRows(Side(*top, *middle), first, turn);
  if (turn < end) fillRows(Side(*middle, *bottom), turn, end);
}

void TrianglePainter::fillRow(const Surface& surface, int row, double left, double right) {
  const int width = raster_.size().width;
  const int first = firstPixel(left, width);
  const int end = firstPixel(right, width);
  if (first >= end) return;
  if (paint_.texture || !paint_.is_above_ground) return texture(surface, row, first, end);
  Pixel* const colors = raster_.colors(row);
  float* const depths = raster_.inverseDepths(row);
  Thing* const things = raster_.things(row);
  double depth = surface.inverse_depth.at(first + 0.5, row + 0.5);
  double light = surface.light.at(first + 0.5, row + 0.5);
  for (int i = first; i < end; ++i) {
    const float nearness = static_cast<float>(depth);
    if (nearness > depths[i]) {
      depths[i] = nearness;
      things[i] = paint_.thing;
      colors[i] = surface.is_flat
                      ? surface.color
                      : lit(surface.color, static_cast<int>(std::clamp(light, 0.0, 256.0)));
    }
    depth += surface.inverse_depth.u;
    light += surface.light.u;
  }
}

// The slower way, for what has a texture or may lie in the ground.
void TrianglePainter::texture(const Surface& surface, int row, int first, int end) {
  Pixel* const colors = raster_.colors(row);
  float* const depths = raster_.inverseDepths(row);
  Thing* const things = raster_.things(row);
  const double v = row + 0.5;
  for (int i = first; i < end; ++i) {
    const double u = i + 0.5;
    const double depth = surface.inverse_depth.at(u, v);
    const float nearness = static_cast<float>(depth);
    if (nearness <= depths[i]) continue;
    if (!paint_.is_above_ground && depth <= ground_.at(u, v)) continue;
    depths[i] = nearness;
    things[i] = paint_.thing;
    Pixel color = surface.color;
    if (paint_.texture || !surface.is_flat) {
      if (paint_.texture)
        color = sample(*paint_.texture, surface.right, surface.down, surface.inverse_depth, u, v);
      color = lit(color, static_cast<int>(std::clamp(surface.light.at(u, v), 0.0, 256.0)));
    }
    colors[i] = color;
  }
}

}  // namespace nao::camera
