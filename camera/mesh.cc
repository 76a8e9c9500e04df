#include "camera/mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nao::camera {
namespace {

/// Points around the unit circle, by halving angles: no sine of the C library, so that every
/// machine draws the same corners.
std::vector<Eigen::Vector2d> unitCircle(int corners) {
  std::vector<Eigen::Vector2d> circle = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  while (static_cast<int>(circle.size()) < corners) {
    std::vector<Eigen::Vector2d> finer;
    for (std::size_t i = 0; i < circle.size(); ++i) {
      const Eigen::Vector2d middle = circle[i] + circle[(i + 1) % circle.size()];
      finer.push_back(circle[i]);
      finer.push_back(middle / std::sqrt(middle.squaredNorm()));
    }
    circle = finer;
  }
  return circle;
}

Mesh makeBox() {
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const int side : {-1, 1}) {
      Vec3 normal = Vec3::Zero();
      normal[axis] = side;
      Vec3 first = Vec3::Zero();
      first[(axis + 1) % 3] = 1;
      const Vec3 second = normal.cross(first);
      const int base = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back({normal - first - second, normal, 0});
      mesh.vertices.push_back({normal + first - second, normal, 0});
      mesh.vertices.push_back({normal + first + second, normal, 0});
      mesh.vertices.push_back({normal - first + second, normal, 0});
      mesh.triangles.push_back({base, base + 1, base + 2});
      mesh.triangles.push_back({base, base + 2, base + 3});
    }
  }
  return mesh;
}

/// Joins two rings of `corners` vertices each that start at `lower` and `upper`.
void addBand(Mesh& mesh, int lower, int upper, int corners) {
  for (int i = 0; i < corners; ++i) {
    const int next = (i + 1) % corners;
    mesh.triangles.push_back({lower + i, lower + next, upper + next});
    mesh.triangles.push_back({lower + i, upper + next, upper + i});
  }
}

int addRing(Mesh& mesh, const std::vector<Eigen::Vector2d>& circle, const Mesh::Vertex& shape) {
  const int base = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector2d& c : circle) {
    const Vec3 corner(c.x() * shape.corner.x(), c.y() * shape.corner.x(), shape.corner.z());
    const Vec3 normal(c.x() * shape.normal.x(), c.y() * shape.normal.x(), shape.normal.z());
    mesh.vertices.push_back({corner, normal, shape.end});
  }
  return base;
}

void addLid(Mesh& mesh, const std::vector<Eigen::Vector2d>& circle, int side) {
  const int corners = static_cast<int>(circle.size());
  const int base = addRing(mesh, circle, {Vec3(1, 0, 0), Vec3(0, 0, side), double(side)});
  for (int i = 1; i + 1 < corners; ++i) {
    if (side > 0) {
      mesh.triangles.push_back({base, base + i, base + i + 1});
    } else {
      mesh.triangles.push_back({base, base + i + 1, base + i});
    }
  }
}

Mesh makeCylinder(int corners) {
  const auto circle = unitCircle(corners);
  Mesh mesh;
  const int lower = addRing(mesh, circle, {Vec3(1, 0, 0), Vec3(1, 0, 0), -1});
  const int upper = addRing(mesh, circle, {Vec3(1, 0, 0), Vec3(1, 0, 0), 1});
  addBand(mesh, lower, upper, corners);
  addLid(mesh, circle, -1);
  addLid(mesh, circle, 1);
  return mesh;
}

Mesh makeCapsule(int corners) {
  const auto circle = unitCircle(corners);
  Mesh mesh;
  int previous = -1;
  // From the south pole to the north pole: circle[k] seen as (across, up) has the angles needed.
  const int quarter = corners / 4;
  for (int half = 0; half < 2; ++half) {
    for (int k = 0; k <= quarter; ++k) {
      const Eigen::Vector2d& c = circle[(half == 0 ? 3 * quarter + k : k) % corners];
      const Vec3 out(c.x(), 0, c.y());
      const int ring = addRing(mesh, circle, {out, out, half == 0 ? -1.0 : 1.0});
      if (previous >= 0) addBand(mesh, previous, ring, corners);
      previous = ring;
    }
  }
  return mesh;
}

double highestOver(const Hull& hull, const Vec3& p) {
  double highest = -std::numeric_limits<double>::max();
  for (const Hull::Face& face : hull.faces) {
    highest = std::max(highest, face.normal.dot(p) - face.offset);
  }
  return highest;
}

constexpr std::array<int, 3> kCorners = {8, 16, 32};

}  // namespace

MeshLibrary::MeshLibrary() : box_(makeBox()) {
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    cylinders_[i] = makeCylinder(kCorners[i]);
    capsules_[i] = makeCapsule(kCorners[i]);
  }
}

const Mesh& MeshLibrary::find(Shape::Kind kind, Roundness roundness) const {
  const std::size_t level = static_cast<std::size_t>(roundness);
  switch (kind) {
    case Shape::Kind::Box:
      return box_;
    case Shape::Kind::Cylinder:
      return cylinders_[level];
    case Shape::Kind::Capsule:
    case Shape::Kind::Sphere:
      return capsules_[level];
    case Shape::Kind::Hull:
      break;
  }
  return box_;
}

Stretch stretchOf(const Shape& shape) {
  switch (shape.kind) {
    case Shape::Kind::Box:
      return {shape.size / 2, 0};
    case Shape::Kind::Cylinder:
    case Shape::Kind::Capsule:
      return {Vec3::Constant(shape.size.x()), shape.size.z() / 2};
    case Shape::Kind::Sphere:
      return {Vec3::Constant(shape.size.x()), 0};
    case Shape::Kind::Hull:
      return {Vec3::Ones(), 0};
  }
  return {};
}

double boundingRadius(const Shape& shape) {
  const double radius = shape.size.x();
  const double half_length = shape.size.z() / 2;
  switch (shape.kind) {
    case Shape::Kind::Box:
      return shape.size.norm() / 2;
    case Shape::Kind::Cylinder:
      return std::sqrt(radius * radius + half_length * half_length);
    case Shape::Kind::Capsule:
      return radius + half_length;
    case Shape::Kind::Sphere:
      return radius;
    case Shape::Kind::Hull:
      return shape.hull->radius;
  }
  return 0;
}

double distanceTo(const Shape& shape, const Vec3& p_S) {
  const double radius = shape.size.x();
  const double half_length = shape.size.z() / 2;
  const double off_axis = p_S.head<2>().norm();
  switch (shape.kind) {
    case Shape::Kind::Box:
      return (p_S.cwiseAbs() - shape.size / 2).maxCoeff();
    case Shape::Kind::Cylinder:
      return std::max(off_axis - radius, std::abs(p_S.z()) - half_length);
    case Shape::Kind::Capsule:
      return Vec3(p_S.x(), p_S.y(), std::max(0.0, std::abs(p_S.z()) - half_length)).norm() - radius;
    case Shape::Kind::Sphere:
      return p_S.norm() - radius;
    case Shape::Kind::Hull:
      return highestOver(*shape.hull, p_S);
  }
  return 0;
}

}  // namespace nao::camera
