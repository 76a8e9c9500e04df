#include <algorithm>
#include <chrono>

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

// The groups every robot has, whatever its file says.
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

}  // namespace

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

void readBody(const std::string& file, const UrdfRobot& urdf, RobotModel& model) {
  Config::read(file, [&](Config& body) {
    model.body_type = body.text("body_type", model.name);
    model.version = body.text("version", "1");
    model.cycle = std::chrono::milliseconds(body.integer("cycle_ms", 1, 100, 10));
    model.fixed_base = body.flag("fixed_base", false);
    if (body.flag("repair_inertia", false)) {
      for (Body& part : model.bodies) part.I_Bcm = nearestSolid(part.I_Bcm);
    }
    readActuators(body, urdf, model);
    readAliases(body, model);
    readGroups(body, model);
    readCoupledLimits(body, model);
    readImu(body, model);
    readFeet(body, model);
    readContactSpheres(body, model);
    readFrames(body, model);
    model.effects = readEffects(body, "effects", model);
    model.variation = readEffects(body, "variation", model);
  });
}

}  // namespace nao
