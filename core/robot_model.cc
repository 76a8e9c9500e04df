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

std::vector<std::string> knownRobots(const std::string& robots_dir) {
  std::vector<std::string> names;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(robots_dir, ignored)) {
    if (fs::exists(entry.path() / "model.urdf")) names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

void requireKnown(const std::string& robots_dir, const std::string& name) {
  const auto known = knownRobots(robots_dir);
  if (std::count(known.begin(), known.end(), name) > 0) return;
  std::string list;
  for (const std::string& robot : known) list += (list.empty() ? "" : ", ") + robot;
  throw InputError("robot '" + name + "' is unknown, expected one of: " +
                   (list.empty() ? "(none in " + robots_dir + ")" : list));
}

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
  requireKnown(robots_dir, name);
  const fs::path folder = fs::path(robots_dir) / name;
  const UrdfRobot urdf = readUrdf((folder / "model.urdf").string());

  auto model = std::make_shared<RobotModel>();
  model->name = name;
  model->bodies = urdf.bodies;
  model->frames = urdf.frames;
  readBody((folder / "body.yaml").string(), urdf, *model);
  checkBodies(urdf, *model);

  const std::string postures = (folder / "postures.yaml").string();
  const std::string cameras = (folder / "cameras.yaml").string();
  if (fs::exists(postures)) readPostures(postures, *model);
  if (fs::exists(cameras)) readCameras(cameras, *model);
  return model;
}

}  // namespace nao
