#include "core/hull.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "core/check.h"
#include "core/config_node.h"

namespace nao {
namespace {

// Grows a tetrahedron point by point: the faces that a point outside sees make way for those
// between their rim and the point (Preparata and Shamos, Computational Geometry, 1985, 3.4).
class HullBuilder {
 public:
  explicit HullBuilder(const std::vector<Vec3>& points) : points_(points) {
    for (const Vec3& p : points_) size_ = std::max(size_, (p - points_[0]).cwiseAbs().maxCoeff());
    if (!start()) return;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i) add(i);
  }

  Hull finish() const {
    Hull hull;
    std::map<int, int> index;  // of the corners that are left, in the order of the points
    for (const Hull::Face& face : faces_) {
      for (const int corner : face.corners) index[corner] = 0;
    }
    for (auto& [corner, place] : index) {
      place = static_cast<int>(hull.corners.size());
      hull.corners.push_back(points_[static_cast<std::size_t>(corner)]);
      hull.radius = std::max(hull.radius, hull.corners.back().norm());
    }
    for (Hull::Face face : faces_) {
      for (int& corner : face.corners) corner = index[corner];
      hull.faces.push_back(face);
    }
    addEdges(hull);
    return hull;
  }

 private:
  const Vec3& at(int i) const { return points_[static_cast<std::size_t>(i)]; }
  double tolerance() const { return 1e-9 * size_; }

  template <class Measure>
  int farthest(const Measure& measure) const {
    int best = 0;
    for (int i = 1; i < static_cast<int>(points_.size()); ++i) {
      if (measure(at(i)) > measure(at(best))) best = i;
    }
    return best;
  }

  bool start() {
    const int a = farthest([](const Vec3& p) { return p.x(); });
    const int b = farthest([&](const Vec3& p) { return (p - at(a)).norm(); });
    const Vec3 line = (at(b) - at(a)).normalized();
    const auto off_line = [&](const Vec3& p) { return (p - at(a)).cross(line).norm(); };
    const int c = farthest(off_line);
    const Vec3 n = (at(b) - at(a)).cross(at(c) - at(a)).normalized();
    const auto off_plane = [&](const Vec3& p) { return std::abs(n.dot(p - at(a))); };
    const int d = farthest(off_plane);
    if (!(off_line(at(c)) > tolerance()) || !(off_plane(at(d)) > tolerance())) return false;
    inside_ = (at(a) + at(b) + at(c) + at(d)) / 4;
    addFace(a, b, c);
    addFace(a, b, d);
    addFace(a, c, d);
    addFace(b, c, d);
    return true;
  }

  void addFace(int a, int b, int c) {
    Hull::Face face{{a, b, c}, (at(b) - at(a)).cross(at(c) - at(a)), 0};
    if (face.normal.norm() <= 0) return;
    face.normal.normalize();
    if (face.normal.dot(inside_ - at(a)) > 0) {
      std::swap(face.corners[1], face.corners[2]);
      face.normal = -face.normal;
    }
    face.offset = face.normal.dot(at(a));
    faces_.push_back(face);
  }

  void add(int i) {
    std::map<std::pair<int, int>, bool> seen;  // directed edges of the faces that go
    std::vector<Hull::Face> kept;
    for (const Hull::Face& face : faces_) {
      if (face.normal.dot(at(i)) - face.offset <= tolerance()) {
        kept.push_back(face);
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) seen[{face.corners[k], face.corners[(k + 1) % 3]}] = true;
    }
    if (seen.empty()) return;
    faces_ = std::move(kept);
    for (const auto& [edge, unused] : seen) {
      if (seen.count({edge.second, edge.first}) == 0) addFace(edge.first, edge.second, i);
    }
  }

  static void addEdges(Hull& hull) {
    constexpr double kFlat = 1 - 1e-9;  // cosine between faces of one plane
    std::map<std::pair<int, int>, Vec3> normals;
    for (const Hull::Face& face : hull.faces) {
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = face.corners[k];
        const int b = face.corners[(k + 1) % 3];
        const auto other = normals.find({b, a});
        if (other == normals.end()) {
          normals[{a, b}] = face.normal;
        } else if (other->second.dot(face.normal) < kFlat) {
          hull.edges.push_back({a, b});
        }
      }
    }
  }

  const std::vector<Vec3>& points_;
  double size_ = 0;
  Vec3 inside_ = Vec3::Zero();
  std::vector<Hull::Face> faces_;
};

}  // namespace

Hull calcHull(const std::vector<Vec3>& points) {
  if (points.size() < 4) return {};
  return HullBuilder(points).finish();
}

std::vector<Vec3> readObjCorners(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw InputError(file + ": can not be read");
  std::vector<Vec3> corners;
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || word != "v") continue;
    Vec3 corner;
    for (double& value : corner) {
      const auto parsed = words >> word ? parseNumber(word) : std::nullopt;
      if (!parsed)
        throw InputError(complaint(file, number, "expected `v x y z` with three numbers"));
      value = *parsed;
    }
    corners.push_back(corner);
  }
  return corners;
}

}  // namespace nao
