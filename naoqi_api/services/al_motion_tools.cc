#include "naoqi_api/services/al_motion_tools.h"

#include <algorithm>
#include <cstdio>

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

// What ALMotion of 1.14 to 2.8 says of itself; clients size their own cycles by it.
constexpr int kNaoqiCycle_ms = 20;

// "V3.3" as getRobotConfig writes it: VERSION_33.
std::string versionTag(std::string version) {
  version.erase(
      std::remove_if(version.begin(), version.end(), [](char c) { return c < '0' || c > '9'; }),
      version.end());
  return "VERSION_" + version;
}

bool hasGroup(const RobotModel& model, const char* name) {
  const auto group = model.groups.find(name);
  return group != model.groups.end() && !group->second.empty();
}

}  // namespace

void AlMotionTools::declare(rpc::Service& service) {
  using Self = AlMotionTools;
  const rpc::Argument name{"name", "Name of a joint, a chain, Body, Joints, Actuators or Chains."};
  addMethod(service, "getJointNames", this, &Self::getBodyNames, "The names of joints.", name)
      .at(254);
  addMethod(service, "getBodyNames", this, &Self::getBodyNames, "The names of joints or chains.",
            name)
      .at(255);
  addMethod(service, "getSensorNames", this, &Self::getSensorNames,
            "The names of the places that getPosition knows besides joints.")
      .at(256);
  addMethod(service, "getLimits", this, &Self::getLimits,
            "[[least angle, largest angle [rad], speed [rad/s], torque [N m]], ...] of joints.",
            name)
      .at(257);
  addMethod(service, "getMotionCycleTime", this, &Self::getMotionCycleTime,
            "The period in which commands change [ms].")
      .at(259);
  addMethod(service, "getRobotConfig", this, &Self::getRobotConfig,
            "[[names], [values]] of the robot's configuration.")
      .at(261);
  addMethod(service, "getSummary", this, &Self::getSummary,
            "A table of all joints: stiffness, commanded and measured angle.")
      .at(262);
}

std::vector<std::string> AlMotionTools::getBodyNames(const std::string& name) {
  const auto& groups = link_.model().groups;
  const auto group = groups.find(name);
  if (group != groups.end()) return group->second;
  return expandNames(link_.model(), {name});
}

std::vector<std::string> AlMotionTools::getSensorNames() {
  std::vector<std::string> names;
  for (const CameraModel& camera : link_.model().cameras) names.push_back(camera.name);
  for (const Frame& frame : link_.model().frames) names.push_back(frame.name);
  return names;
}

rpc::Value AlMotionTools::getLimits(const std::string& name) {
  std::vector<rpc::Value> limits;
  for (const Joint joint : jointsNamed(link_.model(), {name})) {
    const Actuator& actuator = link_.model().actuators[index(joint)];
    limits.push_back(rpc::Value::list(
        {static_cast<float>(actuator.lower), static_cast<float>(actuator.upper),
         static_cast<float>(actuator.max_velocity), static_cast<float>(actuator.max_torque)}));
  }
  return rpc::Value::list(std::move(limits));
}

int AlMotionTools::getMotionCycleTime() { return kNaoqiCycle_ms; }

rpc::Value AlMotionTools::getRobotConfig() {
  const RobotModel& model = link_.model();
  const std::string version = versionTag(model.version);
  const bool has_hands = model.findJoint("LHand").has_value();
  return rpc::Value::list(
      {rpc::Value::list({"Model Type", "Head Version", "Body Version", "Laser", "Legs", "Arms",
                         "Extended Arms", "Hands"}),
       rpc::Value::list({"nao" + model.body_type, version, version, false, hasGroup(model, "LLeg"),
                         hasGroup(model, "LArm"), has_hands, has_hands})});
}

rpc::Pending<std::string> AlMotionTools::getSummary() {
  return link_.whenSettled([this] {
    const auto state = link_.state();
    const auto sensors = link_.sensors();
    std::string table = "---------------------- Model ---------------------------\n";
    char line[128];
    std::snprintf(line, sizeof line, "%20s %10s %10s %10s\n", "BodyName", "Stiffness", "Command",
                  "Sensor");
    table += line;
    for (const std::string& name : getBodyNames("Body")) {
      const Joint joint = *link_.model().findJoint(name);
      std::snprintf(line, sizeof line, "%20.20s %10.6f %10.6f %10.6f\n", name.c_str(),
                    state->stiffness[joint], state->command.angle[joint], sensors->angle[joint]);
      table += line;
    }
    table += "---------------------- Tasks --------------------------\n";
    for (const motion::Task& task : state->tasks) {
      table += task.name + " " + std::to_string(task.id) + "\n";
    }
    return table;
  });
}

}  // namespace nao::services
