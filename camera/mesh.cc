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

/// Where a corner of the unit box lies on the picture of its face: upright on the sides, seen
/// upright on top from where x leads away.
Eigen::Vector2d onFace(const Vec3& corner, const Vec3& normal) {
  const Vec3 up = std::abs(normal.z()) > 0.5 ? Vec3(normal.z(), 0, 0) : Vec3::UnitZ();
  const Vec3 right = up.cross(normal);
  return {0.5 + 0.5 * right.dot(corner), 0.5 - 0.5 * up.dot(corner)};
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
      for (const auto& [a, b] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
        const Vec3 corner = normal + a * first + b * second;
        mesh.vertices.push_back({corner, normal, 0, onFace(corner, normal)});
      }
      mesh.triangles.push_back({base, base + 1, base + 2});
      mesh.triangles.push_back({base, base + 2, base + 3});
    }
  }
  linkEdges(mesh);
  return mesh;
}

/// Whether two vertices stand in one place, whatever the stretch.
bool isSamePlace(const Mesh::Vertex& a, const Mesh::Vertex& b) {
  return a.corner == b.corner && a.end == b.end;
}

/// Leaves out a triangle without area, as at a pole.
void addTriangle(Mesh& mesh, const std::array<int, 3>& corners) {
  for (int i = 0; i < 3; ++i) {
    if (isSamePlace(mesh.vertices[corners[i]], mesh.vertices[corners[(i + 1) % 3]])) return;
  }
  mesh.triangles.push_back(corners);
}

/// Joins two rings of `corners` vertices each that start at `lower` and `upper`.
void addBand(Mesh& mesh, int lower, int upper, int corners) {
  for (int i = 0; i < corners; ++i) {
    const int next = (i + 1) % corners;
    addTriangle(mesh, {lower + i, lower + next, upper + next});
    addTriangle(mesh, {lower + i, upper + next, upper + i});
  }
}

Mesh::Vertex unitRing(const Vec3& corner, const Vec3& normal, int end) {
  return {corner, normal, static_cast<double>(end), Eigen::Vector2d::Zero()};
}

int addRing(Mesh& mesh, const std::vector<Eigen::Vector2d>& circle, const Mesh::Vertex& shape) {
  const int base = static_cast<int>(mesh.vertices.size());
  for (const Eigen::Vector2d& c : circle) {
    const Vec3 corner(c.x() * shape.corner.x(), c.y() * shape.corner.x(), shape.corner.z());
    const Vec3 normal(c.x() * shape.normal.x(), c.y() * shape.normal.x(), shape.normal.z());
    mesh.vertices.push_back({corner, normal, shape.end, Eigen::Vector2d::Zero()});
  }
  return base;
}

void addLid(Mesh& mesh, const std::vector<Eigen::Vector2d>& circle, int side) {
  const int corners = static_cast<int>(circle.size());
  const int base = addRing(mesh, circle, unitRing(Vec3(1, 0, 0), Vec3(0, 0, side), side));
  for (int i = 0; i < corners; ++i) {
    Mesh::Vertex& vertex = mesh.vertices[static_cast<std::size_t>(base + i)];
    vertex.texture = onFace(vertex.corner, vertex.normal);
  }
  for (int i = 1; i + 1 < corners; ++i) {
    if (side > 0) {
      mesh.triangles.push_back({base, base + i, base + i + 1});
    } else {
      mesh.triangles.push_back({base, base + i + 1, base + i});
    }
  }
}

/// A picture goes once around a cylinder, upright, from where its x axis comes out; a lid shows
/// its middle, as a box's top does.
void lookAround(Mesh& mesh, int ring, int corners, double down) {
  for (int i = 0; i < corners; ++i)
    mesh.vertices[static_cast<std::size_t>(ring + i)].texture = {double(i) / (corners - 1), down};
}

Mesh makeCylinder(int corners) {
  const auto circle = unitCircle(corners);
  auto closed = circle;  // its first corner again, where the picture ends
  closed.push_back(circle.front());
  const int around = static_cast<int>(closed.size());
  Mesh mesh;
  const int lower = addRing(mesh, closed, unitRing(Vec3(1, 0, 0), Vec3(1, 0, 0), -1));
  const int upper = addRing(mesh, closed, unitRing(Vec3(1, 0, 0), Vec3(1, 0, 0), 1));
  lookAround(mesh, lower, around, 1);
  lookAround(mesh, upper, around, 0);
  addBand(mesh, lower, upper, around);
  addLid(mesh, circle, -1);
  addLid(mesh, circle, 1);
  linkEdges(mesh);
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
      const int ring = addRing(mesh, circle, unitRing(out, out, half == 0 ? -1 : 1));
      if (previous >= 0) addBand(mesh, previous, ring, corners);
      previous = ring;
    }
  }
  linkEdges(mesh);
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

/// The first vertex that stands where each one does.
std::vector<int> firstInPlace(const Mesh& mesh) {
  using Place = std::array<double, 4>;
  std::map<Place, int> found;
  std::vector<int> first;
  for (const Mesh::Vertex& vertex : mesh.vertices) {
    const Vec3& p = vertex.corner;
    const int number = static_cast<int>(first.size());
    first.push_back(found.emplace(Place{p.x(), p.y(), p.z(), vertex.end}, number).first->second);
  }
  return first;
}

/// Whether the light jumps at an edge: no vertex of one triangle has the normal of the other's.
bool isCrease(const Mesh& mesh, const Mesh::Edge& edge, const std::vector<int>& first) {
  for (const int a : mesh.triangles[edge.triangles[0]]) {
    if (first[a] != first[edge.from]) continue;
    for (const int b : mesh.triangles[edge.triangles[1]]) {
      if (first[b] != first[edge.from]) continue;
      // 5 degrees: below that the two differ by less than 5 of 256 in light.
      return mesh.vertices[a].normal.dot(mesh.vertices[b].normal) < 0.996;
    }
  }
  return false;
}

}  // namespace

void linkEdges(Mesh& mesh) {
  const std::vector<int> first = firstInPlace(mesh);
  std::map<std::pair<int, int>, Mesh::Edge> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const int from = mesh.triangles[t][i];
      const int to = mesh.triangles[t][(i + 1) % 3];
      const auto ends = std::minmax(first[from], first[to]);
      Mesh::Edge& edge = edges.emplace(ends, Mesh::Edge{from, to, {-1, -1}, false}).first->second;
      edge.triangles[edge.triangles[0] < 0 ? 0 : 1] = static_cast<int>(t);
    }
  }
  mesh.edges.clear();
  for (auto& [unused, edge] : edges) {
    if (edge.triangles[1] >= 0) edge.is_crease = isCrease(mesh, edge, first);
    mesh.edges.push_back(edge);
  }
}

MeshLibrary::MeshLibrary() : box_(makeBox()) {
  for (std::size_t i = 0; i < kCorners.size(); ++i) {
    cylinders_[i] = makeCylinder(kCorners[i]);
    capsules_[i] = makeCapsule(kCorners[i]);
  }
}

const Mesh& MeshLibrary::find(const Shape& shape, Roundness roundness) {
  const std::size_t level = static_cast<std::size_t>(roundness);
  if (shape.mesh) return ofFile(shape.mesh);
  switch (shape.kind) {
    case Shape::Kind::Box:
      return box_;
    case Shape::Kind::Cylinder:
      return cylinders_[level];
    case Shape::Kind::Capsule:
    case Shape::Kind::Sphere:
      return capsules_[level];
    case Shape::Kind::Hull:
      return ofHull(shape.hull);
  }
  return box_;
}

const Mesh& MeshLibrary::ofHull(const std::shared_ptr<const Hull>& hull) {
  const auto [found, is_new] = hulls_.try_emplace(hull);
  Mesh& mesh = found->second;
  if (!is_new) return mesh;
  for (const Hull::Face& face : hull->faces) {
    const int base = static_cast<int>(mesh.vertices.size());
    for (const int corner : face.corners) {
      mesh.vertices.push_back({hull->corners[corner], face.normal, 0, Eigen::Vector2d::Zero()});
    }
    mesh.triangles.push_back({base, base + 1, base + 2});
  }
  linkEdges(mesh);
  return mesh;
}

const Mesh& MeshLibrary::ofFile(const std::shared_ptr<const ObjMesh>& file) {
  const auto [found, is_new] = files_.try_emplace(file);
  Mesh& mesh = found->second;
  if (!is_new) return mesh;
  for (const ObjMesh::Triangle& triangle : file->triangles) {
    const int base = static_cast<int>(mesh.vertices.size());
    for (const ObjMesh::Corner& corner : triangle) {
      mesh.vertices.push_back({corner.p, corner.normal, 0, corner.texture});
    }
    mesh.triangles.push_back({base, base + 1, base + 2});
  }
  linkEdges(mesh);
  return mesh;
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
