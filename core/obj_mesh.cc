#include "core/obj_mesh.h"

#include <fstream>
#include <optional>
#include <sstream>

#include "core/check.h"
#include "core/config_node.h"

namespace nao {
namespace {

// OBJ, a line each:  v x y z | vt u v (up) | vn x y z | f CORNER CORNER CORNER ...
// CORNER = v[/[vt][/vn]], numbers from 1 on, negative ones from the last backwards.
class ObjReader {
 public:
  explicit ObjReader(const std::string& file) : file_(file) {}

  ObjMesh read() {
    std::ifstream in(file_);
    if (!in) throw InputError(file_ + ": can not be read");
    std::string line;
    while (++number_, std::getline(in, line)) readLine(line);
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& sentence) {
    throw InputError(complaint(file_, number_, sentence));
  }

  void readLine(const std::string& line) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") places_.push_back(vector(words, 3));
    if (kind == "vn") normals_.push_back(vector(words, 3).normalized());
    if (kind == "vt") pictures_.push_back(vector(words, 2));
    if (kind == "f") readFace(words);
  }

  Vec3 vector(std::istringstream& words, int count) {
    Vec3 v = Vec3::Zero();
    std::string word;
    for (int i = 0; i < count; ++i) {
      const auto parsed = words >> word ? parseNumber(word) : std::nullopt;
      if (!parsed) fail("expected " + std::to_string(count) + " numbers");
      v[i] = *parsed;
    }
    return v;
  }

  void readFace(std::istringstream& words) {
    std::vector<ObjMesh::Corner> corners;
    std::string word;
    while (words >> word) corners.push_back(corner(word));
    if (corners.size() < 3) fail("expected a face of three corners or more");
    for (std::size_t i = 2; i < corners.size(); ++i)
      addTriangle({corners[0], corners[i - 1], corners[i]});
  }

  void addTriangle(ObjMesh::Triangle triangle) {
    const auto& [a, b, c] = triangle;
    const Vec3 across = (b.p - a.p).cross(c.p - a.p);
    if (across.squaredNorm() == 0) return;  // without area
    const Vec3 flat = across / std::sqrt(across.squaredNorm());
    for (ObjMesh::Corner& corner : triangle) {
      if (corner.normal.isZero()) corner.normal = flat;
    }
    mesh_.triangles.push_back(triangle);
  }

  ObjMesh::Corner corner(const std::string& word) {
    std::istringstream parts(word);
    std::string part;
    ObjMesh::Corner corner;
    std::getline(parts, part, '/');
    corner.p = at(places_, part);
    if (std::getline(parts, part, '/') && !part.empty()) {
      const Vec3& picture = at(pictures_, part);
      corner.texture = {picture.x(), 1 - picture.y()};
    }
    if (std::getline(parts, part, '/') && !part.empty()) corner.normal = at(normals_, part);
    return corner;
  }

  const Vec3& at(const std::vector<Vec3>& list, const std::string& word) {
    const auto parsed = parseNumber(word);
    const double count = static_cast<double>(list.size());
    const double index = !parsed ? 0 : *parsed < 0 ? count + *parsed + 1 : *parsed;
    if (!(index >= 1 && index <= count)) fail("expected a corner that stands above, found " + word);
    return list[static_cast<std::size_t>(index) - 1];
  }

  const std::string& file_;
  int number_ = 0;
  std::vector<Vec3> places_, normals_, pictures_;
  ObjMesh mesh_;
};

}  // namespace

ObjMesh readObjMesh(const std::string& file) { return ObjReader(file).read(); }

}  // namespace nao
