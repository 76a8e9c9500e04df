#include "sim/shape_distance.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace nao::sim {
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
  }
  NAO_CHECK(false);
}

}  // namespace nao::sim
