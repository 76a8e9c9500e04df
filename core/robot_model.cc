#include "core/robot_model.h"

#include <algorithm>
#include <filesystem>

#include "core/check.h"
#include "core/robot_model_parts.h"

namespace nao {
namespace {

namespace fs = std::filesystem;

template <class List>
std::optional<std::size_t> findNamed(const List& list, std::string_view name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.name == name; });
  if (found == list.end()) return std::nullopt;
  return static_cast<std::size_t>(found - list.begin());
}

bool isUrdf(const std::string& name) { return fs::path(name).extension() == ".urdf"; }

}  // namespace

std::pair<double, double> CoupledLimit::rangeAt(double driver_angle) const {
  const auto above = std::find_if(rows.begin(), rows.end(), [&](const CoupledLimit::Row& row) {
    return row.driver >= driver_angle;
  });
  if (above == rows.begin()) return {rows.front().min, rows.front().max};
  if (above == rows.end()) return {rows.back().min, rows.back().max};
  const Row& a = *(above - 1);
  const Row& b = *above;
  const double part = (driver_angle - a.driver) / (b.driver - a.driver);
  return {a.min + part * (b.min - a.min), a.max + part * (b.max - a.max)};
}

double RobotModel::totalMass() const {
  double mass = 0;
  for (const Body& body : bodies) mass += body.mass;
  return mass;
}

std::optional<Joint> RobotModel::findJoint(std::string_view joint_name) const {
  const auto alias = aliases.find(std::string(joint_name));
  const auto found = findNamed(actuators, alias == aliases.end() ? joint_name : alias->second);
  if (!found) return std::nullopt;
  return toJoint(*found);
}

std::optional<int> RobotModel::findBody(std::string_view body_name) const {
  const auto found = findNamed(bodies, body_name);
  if (!found) return std::nullopt;
  return static_cast<int>(*found);
}

const Posture* RobotModel::findPosture(std::string_view posture_name) const {
  const auto found = findNamed(postures, posture_name);
  return found ? &postures[*found] : nullptr;
}

std::shared_ptr<const RobotModel> loadRobotModel(const std::string& robots_dir,
                                                 const std::string& name) {
  RobotFiles files;
  if (isUrdf(name)) {
    files.urdf = name;
  } else {
    files = findRobotFiles(robots_dir, name);
  }
  const UrdfRobot urdf = readUrdf(files.urdf);
  auto model = std::make_shared<RobotModel>();
  model->name = isUrdf(name) ? fs::path(name).stem().string() : name;
  model->bodies = urdf.bodies;
  model->frames = urdf.frames;
  if (files.body) {
    readBody(*files.body, urdf, *model);
  } else {
    assumeBody(urdf, *model);
  }
  checkBodies(urdf, *model);
  finishCollisions(urdf, *model);
  if (!files.postures.empty()) readPostures(files.postures, *model);
  if (!files.ways.empty()) readWays(files.ways, *model);
  if (!files.cameras.empty()) readCameras(files.cameras, *model);
  return model;
}

}  // namespace nao
