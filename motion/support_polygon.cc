#include "motion/support_polygon.h"

#include <algorithm>
#include <limits>

namespace nao::motion {
namespace {

using Eigen::Vector2d;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

Vector2d inwards(const Polygon& polygon, std::size_t i) {
  const Vector2d edge = polygon[(i + 1) % polygon.size()] - polygon[i];
  return Vector2d(-edge.y(), edge.x()).normalized();
}

// The part of a convex polygon that is at least `margin` inside the line through `a`.
Polygon cut(const Polygon& polygon, const Vector2d& a, const Vector2d& normal, double margin) {
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d& p = polygon[i];
    const Vector2d& q = polygon[(i + 1) % polygon.size()];
    const double dp = normal.dot(p - a) - margin;
    const double dq = normal.dot(q - a) - margin;
    if (dp >= 0) kept.push_back(p);
    if ((dp > 0 && dq < 0) || (dp < 0 && dq > 0)) kept.push_back(p + dp / (dp - dq) * (q - p));
  }
  return kept;
}

}  // namespace

Polygon calcHull(std::vector<Vector2d> points) {
  std::sort(points.begin(), points.end(), [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  Polygon hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Vector2d& p : points) {
      while (hull.size() >= first + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

Polygon shrink(const Polygon& polygon, double margin) {
  Polygon kept = polygon;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    kept = cut(kept, polygon[i], inwards(polygon, i), margin);
  }
  return kept;
}

Vector2d centreOf(const Polygon& polygon) {
  Vector2d moment = Vector2d::Zero();
  double area = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const double part = cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
    moment += part * (polygon[0] + polygon[i] + polygon[i + 1]) / 3;
    area += part;
  }
  return moment / area;
}

double depthIn(const Polygon& polygon, const Vector2d& point) {
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    depth = std::min(depth, inwards(polygon, i).dot(point - polygon[i]));
  }
  return depth;
}

}  // namespace nao::motion
