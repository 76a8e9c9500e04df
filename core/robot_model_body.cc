#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/robot_model_parts.h"

namespace nao {
namespace {

using Presence = Config::Presence;

void readImu(Config& body, RobotModel& model) {
  body.map("imu", Presence::Optional, [&](Config& imu) {
    model.imu_body = bodyAt(imu, "body", model);
    model.p_BoImu = imu.vector("position");
    model.gyro_axes = imu.integer("gyro_axes", 2, 3);
  });
}

void readCoupledLimits(Config& body, RobotModel& model) {
  body.list("coupled_limits", Presence::Optional, [&](Config& entry) {
    CoupledLimit limit;
    limit.driver = jointAt(entry, "driver", model);
    limit.limited = jointAt(entry, "limited", model);
    for (const auto& row : entry.rows("rows", 3)) {
      if (!limit.rows.empty() && row[0] <= limit.rows.back().driver) {
        entry.reject("rows", "the driver's angle rising from row to row");
      }
      if (row[1] > row[2]) entry.reject("rows", "[driver, min, max] with min up to max");
      limit.rows.push_back({row[0], row[1], row[2]});
    }
    if (limit.rows.empty()) entry.reject("rows", "one row or more");
    limit.stop = entry.flag("stop", true);
    limit.clip = entry.flag("clip", true);
    model.coupled_limits.push_back(limit);
  });
}

// Twice the signed area: above zero when the corners go round counter-clockwise.
double turningOf(const std::vector<Eigen::Vector2d>& outline) {
  double area = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    area += a.x() * b.y() - a.y() * b.x();
  }
  return area;
}

FootModel readFoot(Config& entry, const RobotModel& model) {
  FootModel foot;
  foot.body = bodyAt(entry, "body", model);
  foot.X_BS = translation(entry.vector("sole"));
  for (const auto& row : entry.rows("outline", 2)) foot.outline.emplace_back(row[0], row[1]);
  if (foot.outline.size() < 3 || turningOf(foot.outline) <= 0) {
    entry.reject("outline", "three corners or more, counter-clockwise seen from above");
  }
  const auto sensors = entry.rows("fsr", 3);
  if (sensors.size() != foot.fsr.size()) {
    entry.reject("fsr", "four places: front left, front right, rear left, rear right");
  }
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    foot.fsr[i] = Vec3(sensors[i][0], sensors[i][1], sensors[i][2]);
  }
  return foot;
}

void readFeet(Config& body, RobotModel& model) {
  body.list("feet", Presence::Optional,
            [&](Config& entry) { model.feet.push_back(readFoot(entry, model)); });
  if (!model.feet.empty() && model.feet.size() != 2) {
    body.reject("feet", "two feet, left and right, or none");
  }
}

void readContactSpheres(Config& body, RobotModel& model) {
  body.list("contact_spheres", Presence::Optional, [&](Config& entry) {
    ContactSphere sphere;
    sphere.body = bodyAt(entry, "body", model);
    sphere.p_B = entry.vector("position");
    sphere.radius = entry.number("radius", kPositive);
    model.contact_spheres.push_back(sphere);
  });
}

void readFrames(Config& body, RobotModel& model) {
  body.list("frames", Presence::Optional, [&](Config& entry) {
    model.frames.push_back({entry.text("name"), bodyAt(entry, "body", model), entry.pose()});
  });
}

void readAliases(Config& body, RobotModel& model) {
  body.map("aliases", Presence::Optional, [&](Config& aliases) {
    for (const std::string& alias : aliases.keys()) {
      const Joint joint = jointAt(aliases, alias, model);
      model.aliases[alias] = model.actuators[index(joint)].name;
    }
  });
}

// A group holds joints, or names of other groups ("Chains").
void readGroups(Config& body, RobotModel& model) {
  body.map("groups", Presence::Optional, [&](Config& groups) {
    const auto names = groups.keys();
    for (const std::string& name : names) {
      if (model.findJoint(name)) groups.reject(name, "a name no joint has");
      for (const std::string& member : groups.texts(name)) {
        const bool is_group = std::count(names.begin(), names.end(), member) > 0;
        if (!is_group && !model.findJoint(member)) {
          groups.reject(name, "names of joints or groups, '" + member + "' is neither");
        }
      }
      model.groups[name] = groups.texts(name);
    }
  });
  addDefaultGroups(model);
}

// Motors that share a board, by the board's name.
void readBoards(Config& body, RobotModel& model) {
  body.map("boards", Presence::Optional, [&](Config& boards) {
    int number = 0;
    for (const std::string& board : boards.keys()) {
      for (const std::string& name : boards.texts(board)) {
        const auto joint = model.findJoint(name);
        if (!joint || model.actuators[index(*joint)].board >= 0) {
          boards.reject(board, "names of actuators, each on one board, '" + name + "' is not");
        }
        model.actuators[index(*joint)].board = number;
      }
      ++number;
    }
  });
}

// Indices of the frames named at `key`.
std::vector<int> framesAt(Config& config, const std::string& key, const RobotModel& model) {
  std::vector<int> indices;
  for (const std::string& name : config.texts(key)) {
    const auto found = std::find_if(model.frames.begin(), model.frames.end(),
                                    [&](const Frame& frame) { return frame.name == name; });
    if (found == model.frames.end()) config.reject(key, "names of `frames`, '" + name + "' is not");
    indices.push_back(static_cast<int>(found - model.frames.begin()));
  }
  return indices;
}

void readSonar(Config& body, RobotModel& model) {
  body.map("sonar", Presence::Optional, [&](Config& entry) {
    SonarModel& sonar = model.sonar;
    sonar.min_range = entry.number("min", kNotNegative);
    sonar.max_range = entry.number("max", kPositive);
    if (sonar.max_range <= sonar.min_range) entry.reject("max", "more than `min`");
    sonar.half_cone = 0.5 * entry.number("cone_deg", {1, 180}) * M_PI / 180;
    sonar.transmitters = framesAt(entry, "transmitters", model);
    sonar.receivers = framesAt(entry, "receivers", model);
  });
}

void readBattery(Config& body, RobotModel& model) {
  body.map("battery", Presence::Optional, [&](Config& entry) {
    model.battery.capacity_ah = entry.number("capacity_Ah", kPositive);
  });
}

}  // namespace

void addDefaultGroups(RobotModel& model) {
  std::vector<std::string> all;
  std::vector<std::string> turning;
  std::vector<std::string> others;
  for (const Actuator& actuator : model.actuators) {
    all.push_back(actuator.name);
    (actuator.coordinates.empty() ? others : turning).push_back(actuator.name);
  }
  model.groups.emplace("Body", all);
  model.groups.emplace("JointActuators", all);
  model.groups.emplace("Joints", turning);
  model.groups.emplace("Actuators", others);
}

Joint jointAt(Config& config, const std::string& key, const RobotModel& model) {
  const auto joint = model.findJoint(config.text(key));
  if (!joint) config.reject(key, "the name of an actuator");
  return *joint;
}

int bodyAt(Config& config, const std::string& key, const RobotModel& model) {
  const auto body = model.findBody(config.text(key));
  if (!body) config.reject(key, "the name of a link of model.urdf");
  return *body;
}

void readBody(const ConfigNode& file, const UrdfRobot& urdf, RobotModel& model) {
  Config::read(file, [&](Config& body) {
    body.has("like");  // followed already
    model.body_type = body.text("body_type", model.name);
    model.version = body.text("version", "1");
    model.cycle = std::chrono::milliseconds(body.integer("cycle_ms", 1, 100, 10));
    model.fixed_base = body.flag("fixed_base", false);
    if (body.flag("repair_inertia", false)) {
      for (Body& part : model.bodies) part.I_Bcm = nearestSolid(part.I_Bcm);
    }
    readSolids(body, model);
    readActuators(body, urdf, model);
    readAliases(body, model);
    readGroups(body, model);
    readBoards(body, model);
    readCoupledLimits(body, model);
    readImu(body, model);
    readFeet(body, model);
    readContactSpheres(body, model);
    readFrames(body, model);
    readSonar(body, model);
    readBattery(body, model);
    readNoCollision(body, model);
    model.effects = readEffects(body, "effects", model);
    model.variation = readEffects(body, "variation", model);
    body.map("noise", Config::Presence::Optional, [&](Config& noise) {
      model.start_sd = 1e-3 * noise.number("start_sd_ms", kNotNegative, 0);
      model.noise = readEffects(noise, "effects", model);
    });
  });
}

}  // namespace nao
