#include <algorithm>

#include "core/robot_model_parts.h"

namespace nao {
namespace {

std::string nameOf(int body, const RobotModel& model) {
  return model.bodies[static_cast<std::size_t>(body)].name;
}

}  // namespace

void forbidContact(int a, int b, RobotModel& model) {
  const std::pair<int, int> pair = std::minmax(a, b);
  const auto at = std::lower_bound(model.no_collision.begin(), model.no_collision.end(), pair);
  if (at == model.no_collision.end() || *at != pair) model.no_collision.insert(at, pair);
}

void readNoCollision(Config& body, RobotModel& model) {
  if (!body.has("no_collision")) return;
  for (const auto& [a, b] : body.pairs("no_collision")) {
    const auto first = model.findBody(a);
    const auto second = model.findBody(b);
    if (!first || !second || first == second) {
      body.reject("no_collision", "pairs of links of model.urdf, [" + a + ", " + b + "] is none");
    }
    forbidContact(*first, *second, model);
  }
}

void finishCollisions(const UrdfRobot& urdf, RobotModel& model) {
  std::string meshes_alone;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    if (body.parent >= 0) forbidContact(body.parent, static_cast<int>(i), model);
    if (!urdf.has_mesh[i] || !body.collisions.empty()) continue;
    meshes_alone += (meshes_alone.empty() ? "" : ", ") + nameOf(static_cast<int>(i), model);
  }
  if (!meshes_alone.empty()) {
    model.notes.push_back("collision meshes are left out, so these touch nothing: " + meshes_alone);
  }
}

}  // namespace nao
