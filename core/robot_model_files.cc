#include <algorithm>
#include <filesystem>

#include "core/check.h"
#include "core/files.h"
#include "core/robot_model_parts.h"

namespace nao {
namespace {

namespace fs = std::filesystem;

const char* const kLike = "like";

bool holdsRobot(const fs::path& folder) {
  return fs::exists(folder / "model.urdf") || fs::exists(folder / "body.yaml");
}

std::string knownRobots(const std::string& robots_dir) {
  std::vector<std::string> names;
  for (const fs::path& folder : listReadable(robots_dir)) {
    if (holdsRobot(folder)) names.push_back(folder.filename().string());
  }
  std::string list;
  for (const std::string& robot : names) list += (list.empty() ? "" : ", ") + robot;
  return list.empty() ? "(none in " + robots_dir + ")" : list;
}

bool isKnown(const std::string& robots_dir, const std::string& name) {
  const bool is_path = name.empty() || fs::path(name).has_parent_path() || name[0] == '.';
  return !is_path && holdsRobot(fs::path(robots_dir) / name);
}

// Takes `file` of this folder unless a nearer folder had one.
void take(const fs::path& folder, const char* file, std::string& place) {
  if (place.empty() && fs::exists(folder / file)) place = (folder / file).string();
}

// Adds to `body` the keys of `other` that it does not have.
void complete(ConfigNode& body, const ConfigNode& other) {
  for (std::size_t i = 0; i < other.keys.size(); ++i) {
    if (other.keys[i] == kLike || body.find(other.keys[i]) != nullptr) continue;
    body.keys.push_back(other.keys[i]);
    body.children.push_back(other.children[i]);
  }
}

// The robot that `body` is like, or empty.
std::string likeOf(const ConfigNode& body, const std::string& robots_dir,
                   const std::vector<std::string>& visited) {
  const ConfigNode* like = body.find(kLike);
  if (like == nullptr) return {};
  const auto reject = [&](const std::string& expected) {
    throw InputError(
        complaint(*like, "`like`: expected " + expected + ", found " + like->described()));
  };
  if (like->kind != ConfigNode::Kind::Scalar || !isKnown(robots_dir, like->text)) {
    reject("one of " + knownRobots(robots_dir));
  }
  if (std::count(visited.begin(), visited.end(), like->text) > 0) {
    reject("a robot that is not itself like this one");
  }
  return like->text;
}

}  // namespace

RobotFiles findRobotFiles(const std::string& robots_dir, const std::string& name) {
  if (!isKnown(robots_dir, name)) {
    throw InputError("robot '" + name + "' is unknown, expected one of: " +
                     knownRobots(robots_dir) + "; or a path that ends in .urdf");
  }
  RobotFiles files;
  std::vector<std::string> visited;
  for (std::string robot = name; !robot.empty();) {
    visited.push_back(robot);
    const fs::path folder = fs::path(robots_dir) / robot;
    take(folder, "model.urdf", files.urdf);
    take(folder, "postures.yaml", files.postures);
    take(folder, "ways.yaml", files.ways);
    take(folder, "cameras.yaml", files.cameras);
    if (!fs::exists(folder / "body.yaml")) break;
    const ConfigNode body = parseConfigFile((folder / "body.yaml").string());
    if (!files.body) {
      files.body = body;
    } else {
      complete(*files.body, body);
    }
    robot = likeOf(body, robots_dir, visited);
  }
  if (files.urdf.empty()) {
    throw InputError(complaint(*files.body, "expected a model.urdf beside this file, or `like:` " +
                                                std::string("and the name of a robot with one")));
  }
  return files;
}

}  // namespace nao
