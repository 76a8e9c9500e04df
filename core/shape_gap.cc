#include "core/shape_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/shape_distance.h"

namespace nao {
namespace {

constexpr int kHalvings = 30;    // of an edge: to a micrometre on a metre, and further
constexpr int kPrismSides = 16;  // of a cylinder beside another; 2 % of its radius at most

bool isRound(const Shape& shape) {
  return shape.kind == Shape::Kind::Sphere || shape.kind == Shape::Kind::Capsule;
}

struct Segment {
  Vec3 from, way;
};

// The axis of a sphere or capsule.
Segment axisOf(const Shape& shape, const Pose& X) {
  const double length = shape.kind == Shape::Kind::Capsule ? shape.size.z() : 0;
  const Vec3 way = length * X.linear().col(2);
  return {X.translation() - way / 2, way};
}

ShapeGap gapOf(const Vec3& p_a, double radius_a, const Vec3& p_b, double radius_b) {
  const Vec3 away = p_a - p_b;
  const double length = away.norm();
  ShapeGap gap;
  gap.n_W = length > 0 ? Vec3(away / length) : Vec3(Vec3::UnitZ());
  gap.distance = length - radius_a - radius_b;
  gap.p_W = 0.5 * (p_a - radius_a * gap.n_W + p_b + radius_b * gap.n_W);
  return gap;
}

// The points of two segments that are nearest to each other: Ericson, Real-Time Collision
// Detection (2005), section 5.1.9.
ShapeGap roundGap(const Segment& a, double radius_a, const Segment& b, double radius_b) {
  const Vec3 r = a.from - b.from;
  const double aa = a.way.squaredNorm();
  const double bb = b.way.squaredNorm();
  const double ab = a.way.dot(b.way);
  const double ar = a.way.dot(r);
  const double br = b.way.dot(r);
  const double det = aa * bb - ab * ab;
  double s = det > 1e-12 * aa * bb ? std::clamp((ab * br - ar * bb) / det, 0.0, 1.0) : 0.5;
  const double t = bb > 0 ? std::clamp((ab * s + br) / bb, 0.0, 1.0) : 0;
  s = aa > 0 ? std::clamp((ab * t - ar) / aa, 0.0, 1.0) : 0;
  return gapOf(a.from + s * a.way, radius_a, b.from + t * b.way, radius_b);
}

// A distance to a convex solid along a segment is convex: where it no longer falls is its least.
double nearestOn(const Segment& edge, const Shape& solid) {
  const auto slope = [&](double t) {
    return calcSurfacePoint(solid, edge.from + t * edge.way).normal.dot(edge.way);
  };
  if (slope(0) >= 0) return 0;
  if (slope(1) <= 0) return 1;
  double low = 0;
  double high = 1;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (slope(middle) > 0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

// Of a segment with a radius against a solid at X_WS; the normal points towards the segment.
ShapeGap edgeGap(const Segment& edge_W, double radius, const Shape& solid, const Pose& X_WS) {
  const Mat3 R_SW = X_WS.linear().transpose();
  const Segment edge{R_SW * (edge_W.from - X_WS.translation()), R_SW * edge_W.way};
  const double t = edge.way.isZero(0) ? 0 : nearestOn(edge, solid);
  const SurfacePoint surface = calcSurfacePoint(solid, edge.from + t * edge.way);
  ShapeGap gap;
  gap.n_W = X_WS.linear() * surface.normal;
  gap.distance = surface.distance - radius;
  gap.p_W = edge_W.from + t * edge_W.way - (radius + gap.distance / 2) * gap.n_W;
  return gap;
}

template <class Visit>
void visitBoxEdges(const Vec3& half, const Pose& X, const Visit& visit) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 from = -half;
      if (corner & 1) from[u] = half[u];
      if (corner & 2) from[v] = half[v];
      visit(Segment{X * from, X.linear() * (2 * half[axis] * Vec3::Unit(axis))});
    }
  }
}

template <class Visit>
void visitPrismEdges(double radius, double length, const Pose& X, const Visit& visit) {
  const auto corner = [&](int i, double z) {
    const double angle = 2 * M_PI * i / kPrismSides;
    return Vec3(X * Vec3(radius * std::cos(angle), radius * std::sin(angle), z));
  };
  for (int i = 0; i < kPrismSides; ++i) {
    const Vec3 low = corner(i, -length / 2);
    const Vec3 high = corner(i, length / 2);
    visit(Segment{low, high - low});
    visit(Segment{low, corner(i + 1, -length / 2) - low});
    visit(Segment{high, corner(i + 1, length / 2) - high});
  }
}

template <class Visit>
void visitHullEdges(const Hull& hull, const Pose& X, const Visit& visit) {
  for (const auto& [a, b] : hull.edges) {
    const Vec3& from = hull.corners[static_cast<std::size_t>(a)];
    const Vec3& to = hull.corners[static_cast<std::size_t>(b)];
    visit(Segment{X * from, X.linear() * (to - from)});
  }
}

template <class Visit>
void visitEdges(const Shape& shape, const Pose& X, const Visit& visit) {
  if (isRound(shape)) return visit(axisOf(shape, X));
  if (shape.kind == Shape::Kind::Box) return visitBoxEdges(shape.size / 2, X, visit);
  if (shape.kind == Shape::Kind::Hull) return visitHullEdges(*shape.hull, X, visit);
  visitPrismEdges(shape.size.x(), shape.size.z(), X, visit);
}

// The least gap of a's edges to b, whose normal points towards a.
ShapeGap leastGap(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  ShapeGap least;
  least.distance = std::numeric_limits<double>::max();
  const double radius = isRound(a) ? a.size.x() : 0;
  visitEdges(a, X_WA, [&](const Segment& edge) {
    const ShapeGap gap = edgeGap(edge, radius, b, X_WB);
    if (gap.distance < least.distance) least = gap;
  });
  return least;
}

ShapeGap reversed(ShapeGap gap) {
  gap.n_W = -gap.n_W;
  return gap;
}

}  // namespace

ShapeGap calcShapeGap(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  if (isRound(a) && isRound(b)) {
    return roundGap(axisOf(a, X_WA), a.size.x(), axisOf(b, X_WB), b.size.x());
  }
  if (isRound(a)) return leastGap(a, X_WA, b, X_WB);
  if (isRound(b)) return reversed(leastGap(b, X_WB, a, X_WA));
  const ShapeGap of_a = leastGap(a, X_WA, b, X_WB);
  const ShapeGap of_b = reversed(leastGap(b, X_WB, a, X_WA));
  return of_a.distance < of_b.distance ? of_a : of_b;
}

}  // namespace nao
