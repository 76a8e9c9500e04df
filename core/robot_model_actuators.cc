#include <algorithm>
#include <cmath>
#include <map>

#include "core/check.h"
#include "core/config_node.h"
#include "core/robot_model_parts.h"

namespace nao {
namespace {

constexpr double kRadPerSecondPerRpm = 2 * M_PI / 60;

// A motor, its gear and its servo, shared by the actuators that name it. Motors are given as in
// their data sheets, at the motor's own shaft; the gear takes them to the joint.
Actuator readDrive(Config& drive) {
  Actuator actuator;
  const double ratio = drive.number("gear_ratio", kPositive);
  actuator.no_load_speed =
      drive.number("motor_no_load_speed_rpm", kPositive) * kRadPerSecondPerRpm / ratio;
  actuator.stall_torque = drive.number("motor_stall_torque_mNm", kPositive) * 1e-3 * ratio;
  actuator.efficiency = drive.number("efficiency", {0.01, 1});
  actuator.rotor_inertia = drive.number("rotor_inertia", kNotNegative);
  actuator.kp = drive.number("kp", kNotNegative);
  actuator.kd = drive.number("kd", kNotNegative);
  return actuator;
}

std::map<std::string, Actuator> readDrives(Config& body) {
  std::map<std::string, Actuator> drives;
  body.map("drives", Config::Presence::Required, [&](Config& all) {
    for (const std::string& name : all.keys()) {
      all.map(name, Config::Presence::Required,
              [&](Config& drive) { drives[name] = readDrive(drive); });
    }
  });
  return drives;
}

const UrdfHinge* findHinge(const UrdfRobot& urdf, const std::string& name) {
  const auto found = std::find_if(urdf.hinges.begin(), urdf.hinges.end(),
                                  [&](const UrdfHinge& hinge) { return hinge.name == name; });
  return found == urdf.hinges.end() ? nullptr : &*found;
}

// Range and speed stand in the URDF; an actuator without a hinge (a hand) brings its own.
void readRange(Config& entry, const UrdfRobot& urdf, Actuator& actuator) {
  if (const UrdfHinge* hinge = findHinge(urdf, actuator.name)) {
    if (!hinge->mimics.empty()) {
      entry.reject("name", "a hinge of its own: " + hinge->name + " follows " + hinge->mimics);
    }
    actuator.lower = hinge->lower;
    actuator.upper = hinge->upper;
    actuator.max_velocity = hinge->max_velocity;
    actuator.max_torque = hinge->max_torque;
    return;
  }
  if (!entry.has("range")) entry.reject("name", "a joint of model.urdf, or a `range` beside it");
  const auto range = entry.numbers("range", 2);
  if (range[0] >= range[1]) entry.reject("range", "the lower end first");
  actuator.lower = range[0];
  actuator.upper = range[1];
  actuator.max_velocity = entry.number("max_velocity", kPositive);
  actuator.max_torque = entry.number("max_torque", kPositive);
}

// A hinge with the drive `none` turns freely: it has sensors and a name, but no torque.
Actuator driveAt(Config& entry, const std::map<std::string, Actuator>& drives) {
  const std::string name = entry.text("drive");
  if (name == "none") {
    Actuator nothing;
    nothing.no_load_speed = 1;  // any: a torque of 0 falls to 0
    return nothing;
  }
  const auto drive = drives.find(name);
  if (drive == drives.end()) entry.reject("drive", "one of `drives`, or none");
  return drive->second;
}

void readActuator(Config& entry, const std::map<std::string, Actuator>& drives,
                  const UrdfRobot& urdf, RobotModel& model) {
  Actuator actuator = driveAt(entry, drives);
  actuator.name = entry.text("name");
  if (model.findJoint(actuator.name)) entry.reject("name", "each name once");
  if (model.actuators.size() == kMaxJoints) {
    entry.fail("more than " + std::to_string(kMaxJoints) + " actuators");
  }
  readRange(entry, urdf, actuator);
  model.actuators.push_back(actuator);
}

void addCoordinate(const UrdfHinge& hinge, const std::string& file, RobotModel& model) {
  const auto joint = model.findJoint(hinge.mimics.empty() ? hinge.name : hinge.mimics);
  if (!joint) {
    throw InputError(complaint(file, hinge.line,
                               "joint '" + hinge.name + "': expected an actuator for it in " +
                                   "body.yaml (with `drive: none` if it turns freely), or a " +
                                   "<mimic> of a joint that has one"));
  }
  Actuator& actuator = model.actuators[index(*joint)];
  actuator.coordinates.push_back(static_cast<int>(model.coordinates.size()));
  model.coordinates.push_back({hinge.name, *joint, hinge.lower, hinge.upper});
}

}  // namespace

void readActuators(Config& body, const UrdfRobot& urdf, RobotModel& model) {
  const auto drives = readDrives(body);
  body.list("actuators", Config::Presence::Required,
            [&](Config& entry) { readActuator(entry, drives, urdf, model); });
  connectHinges(urdf, model);
}

void connectHinges(const UrdfRobot& urdf, RobotModel& model) {
  for (const UrdfHinge& hinge : urdf.hinges) addCoordinate(hinge, urdf.file, model);
  for (const UrdfHinge& hinge : urdf.hinges) {
    if (!hinge.mimics.empty()) model.aliases[hinge.name] = hinge.mimics;
  }
}

}  // namespace nao
