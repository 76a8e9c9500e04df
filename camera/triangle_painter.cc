#include "camera/triangle_painter.h"

#include <cmath>

namespace nao::camera {
namespace {

LitCorner onNearPlane(const LitCorner& a, const LitCorner& b) {
  const double part = (kNearPlane - a.p_C.x()) / (b.p_C.x() - a.p_C.x());
  LitCorner cut{a.p_C + part * (b.p_C - a.p_C), a.light + part * (b.light - a.light)};
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

/// Where the edge between two corners, given from top to bottom, crosses row centre v.
double crossing(double top_u, double top_v, double bottom_u, double bottom_v, double v) {
  return top_u + (v - top_v) * ((bottom_u - top_u) / (bottom_v - top_v));
}

}  // namespace

TrianglePainter::ScreenCorner TrianglePainter::project(const LitCorner& corner) const {
  const double inverse = 1 / corner.p_C.x();
  return {lens_.cx - lens_.fx * corner.p_C.y() * inverse,
          lens_.cy - lens_.fy * corner.p_C.z() * inverse, inverse, corner.light * inverse};
}

void TrianglePainter::paint(const std::array<LitCorner, 3>& corners, Pixel color) {
  const Clipped clipped = clipAtNearPlane(corners);
  if (clipped.count < 3) return;
  const double light = corners[0].light;
  const bool flat = light == corners[1].light && light == corners[2].light;
  const ScreenCorner first = project(clipped.corners[0]);
  ScreenCorner second = project(clipped.corners[1]);
  for (int i = 2; i < clipped.count; ++i) {
    const ScreenCorner third = project(clipped.corners[i]);
    paintOnScreen({first, second, third}, color, flat, light);
    second = third;
  }
}

void TrianglePainter::paintOnScreen(std::array<ScreenCorner, 3> corners, Pixel color, bool flat,
                                    double light) {
  const auto& [a, b, c] = corners;
  const double ab_u = b.u - a.u, ab_v = b.v - a.v, ac_u = c.u - a.u, ac_v = c.v - a.v;
  // v counts downwards, so a front face, counter-clockwise to the eye, has a negative area.
  const double area = ab_u * ac_v - ac_u * ab_v;
  if (!(area < 0)) return;
  // The linear form that takes the corners' values at the corners.
  const auto through = [&](double at_a, double at_b, double at_c) {
    const double ab = at_b - at_a, ac = at_c - at_a;
    const double du = (ab * ac_v - ac * ab_v) / area;
    const double dv = (ac * ab_u - ab * ac_u) / area;
    return LinearForm{du, dv, at_a - du * a.u - dv * a.v};
  };
  Surface surface;
  surface.color = color;
  surface.inverse_depth = through(a.inverse_depth, b.inverse_depth, c.inverse_depth);
  surface.flat = flat;
  if (flat) {
    surface.color = lit(color, static_cast<int>(light));
  } else {
    surface.light_over_depth = through(a.light_over_depth, b.light_over_depth, c.light_over_depth);
  }
  fill(corners, surface);
}

void TrianglePainter::fill(std::array<ScreenCorner, 3> corners, const Surface& surface) {
  // From top to bottom; equal heights by u, so that triangles that share an edge cut it alike.
  const auto higher = [](const ScreenCorner& a, const ScreenCorner& b) {
    return a.v < b.v || (a.v == b.v && a.u < b.u);
  };
  std::sort(corners.begin(), corners.end(), higher);
  const auto& [top, middle, bottom] = corners;
  const int height = raster_.size().height;
  const int end = firstPixel(bottom.v, height);
  for (int row = firstPixel(top.v, height); row < end; ++row) {
    const double v = row + 0.5;
    const double far_side = crossing(top.u, top.v, bottom.u, bottom.v, v);
    const double near_side = v < middle.v ? crossing(top.u, top.v, middle.u, middle.v, v)
                                          : crossing(middle.u, middle.v, bottom.u, bottom.v, v);
    fillRow(row, std::min(far_side, near_side), std::max(far_side, near_side), surface);
  }
}

void TrianglePainter::fillRow(int row, double left, double right, const Surface& surface) {
  const int width = raster_.size().width;
  const int end = firstPixel(right, width);
  const int first = firstPixel(left, width);
  Pixel* const colors = raster_.colors(row);
  float* const depths = raster_.inverseDepths(row);
  double depth = surface.inverse_depth.at(first + 0.5, row + 0.5);
  double light = surface.light_over_depth.at(first + 0.5, row + 0.5);
  double ground = ground_.at(first + 0.5, row + 0.5);
  for (int i = first; i < end; ++i) {
    const float nearness = static_cast<float>(depth);
    if (nearness > depths[i] && depth > ground) {
      depths[i] = nearness;
      colors[i] = surface.flat
                      ? surface.color
                      : lit(surface.color, static_cast<int>(std::clamp(light / depth, 0.0, 256.0)));
    }
    depth += surface.inverse_depth.u;
    light += surface.light_over_depth.u;
    ground += ground_.u;
  }
}

}  // namespace nao::camera
