#include "core/shape_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/check.h"

namespace nao {
namespace {

SurfacePoint fromSegment(const Vec3& p, double half_length, double radius) {
  const Vec3 nearest(0, 0, std::clamp(p.z(), -half_length, half_length));
  const Vec3 away = p - nearest;
  const double length = away.norm();
  return {length - radius, length > 0 ? Vec3(away / length) : Vec3(Vec3::UnitX())};
}

SurfacePoint fromBox(const Vec3& p, const Vec3& half) {
  const Vec3 beyond = p.cwiseAbs() - half;
  const Vec3 sign(std::copysign(1.0, p.x()), std::copysign(1.0, p.y()), std::copysign(1.0, p.z()));
  int axis = 0;
  if (beyond.maxCoeff(&axis) <= 0) return {beyond[axis], sign[axis] * Vec3::Unit(axis)};
  const Vec3 away = beyond.cwiseMax(0.0).cwiseProduct(sign);
  return {away.norm(), away.normalized()};
}

// The point of a triangle that is nearest to p: Ericson, Real-Time Collision Detection (2005),
// section 5.1.5.
Vec3 nearestOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const double d1 = ab.dot(p - a);
  const double d2 = ac.dot(p - a);
  if (d1 <= 0 && d2 <= 0) return a;
  const double d3 = ab.dot(p - b);
  const double d4 = ac.dot(p - b);
  if (d3 >= 0 && d4 <= d3) return b;
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return a + d1 / (d1 - d3) * ab;
  const double d5 = ab.dot(p - c);
  const double d6 = ac.dot(p - c);
  if (d6 >= 0 && d5 <= d6) return c;
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return a + d2 / (d2 - d6) * ac;
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b);
  return a + (vb * ab + vc * ac) / (va + vb + vc);
}

SurfacePoint fromHull(const Vec3& p, const Hull& hull) {
  SurfacePoint inside{-std::numeric_limits<double>::max(), Vec3::UnitZ()};
  Vec3 nearest = Vec3::Zero();
  double least = std::numeric_limits<double>::max();
  for (const Hull::Face& face : hull.faces) {
    const double height = face.normal.dot(p) - face.offset;
    if (height > inside.distance) inside = {height, face.normal};
    if (height <= 0) continue;  // the face looks away
    const auto corner = [&](std::size_t i) {
      return hull.corners[static_cast<std::size_t>(face.corners[i])];
    };
    const Vec3 q = nearestOnTriangle(p, corner(0), corner(1), corner(2));
    if ((p - q).norm() >= least) continue;
    least = (p - q).norm();
    nearest = q;
  }
  if (inside.distance <= 0 || least <= 0) return inside;
  return {least, (p - nearest) / least};
}

SurfacePoint fromCylinder(const Vec3& p, double half_length, double radius) {
  const double rho = std::hypot(p.x(), p.y());
  const Vec3 outward = rho > 0 ? Vec3(p.x() / rho, p.y() / rho, 0) : Vec3(Vec3::UnitX());
  const Vec3 end = std::copysign(1.0, p.z()) * Vec3::UnitZ();
  const double side = rho - radius;
  const double cap = std::abs(p.z()) - half_length;
  if (side <= 0 && cap <= 0)
    return side > cap ? SurfacePoint{side, outward} : SurfacePoint{cap, end};
  const Vec3 away = std::max(side, 0.0) * outward + std::max(cap, 0.0) * end;
  return {away.norm(), away.normalized()};
}

}  // namespace

SurfacePoint calcSurfacePoint(const Shape& shape, const Vec3& p_S) {
  switch (shape.kind) {
    case Shape::Kind::Sphere:
      return fromSegment(p_S, 0, shape.size.x());
    case Shape::Kind::Capsule:
      return fromSegment(p_S, shape.size.z() / 2, shape.size.x());
    case Shape::Kind::Box:
      return fromBox(p_S, shape.size / 2);
    case Shape::Kind::Cylinder:
      return fromCylinder(p_S, shape.size.z() / 2, shape.size.x());
    case Shape::Kind::Hull:
      return fromHull(p_S, *shape.hull);
  }
  NAO_CHECK(false);
}

double boundingRadius(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::Sphere:
      return shape.size.x();
    case Shape::Kind::Capsule:
      return shape.size.x() + shape.size.z() / 2;
    case Shape::Kind::Box:
      return shape.size.norm() / 2;
    case Shape::Kind::Cylinder:
      return std::hypot(shape.size.x(), shape.size.z() / 2);
    case Shape::Kind::Hull:
      return shape.hull->radius;
  }
  NAO_CHECK(false);
}

}  // namespace nao
