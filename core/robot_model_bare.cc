#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/check.h"
#include "core/config_node.h"
#include "core/robot_model_parts.h"

// What is assumed of a robot that is a URDF alone. All of it is told in RobotModel::notes.
//   motor of a hinge   stall torque = effort, no-load speed = velocity, ideal gear, as the URDF's
//                      limits are the only figures there are
//   servo              kp = 50 effort per rad, rotor inertia 0.0025 effort, kd = 1.4 sqrt(1.5 kp
//   J):
//                      the proportions of robots/nao_h21_v33, where they are stable and stiff
//   effort 0           no motor, the hinge turns freely
//   velocity 0         10 rad/s
//   root               bolted down if it is called `world` or has no mass
//   inertia            the nearest that a solid can have, where the file's is none
//   ground             met with the collision solids: spheres, and the corners and rims of others
//   itself             touches itself with them, but not across one body: solids drawn for their
//                      looks overlap around a joint of two hinges
//   start              every joint at 0, or at the end of its range that is nearest to 0

namespace nao {
namespace {

constexpr double kGainPerEffort = 50;         // [1/rad]
constexpr double kInertiaPerEffort = 0.0025;  // [s^2]
constexpr double kUsualSpeed = 10;            // [rad/s]
constexpr int kRimPoints = 8;                 // of each rim of a cylinder

std::string join(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

// "sentence: a, b", unless there is nobody to say it of.
void tell(RobotModel& model, const std::string& sentence, const std::vector<std::string>& names) {
  if (!names.empty()) model.notes.push_back(sentence + ": " + join(names));
}

void assumeBase(const UrdfRobot& urdf, RobotModel& model) {
  const Body& root = model.bodies.front();
  model.fixed_base = !urdf.floats && (root.name == "world" || root.mass <= 0);
  if (!model.fixed_base) return;
  model.notes.push_back("root '" + root.name + "' is bolted down: " +
                        (root.name == "world" ? "it is the world" : "it has no mass"));
}

void assumeSolids(RobotModel& model) {
  std::vector<std::string> repaired;
  for (Body& body : model.bodies) {
    const Mat3 solid = nearestSolid(body.I_Bcm);
    if (solid != body.I_Bcm) repaired.push_back(body.name);
    body.I_Bcm = solid;
  }
  tell(model, "inertia replaced by the nearest that a solid can have", repaired);
}

Actuator assumeMotor(const UrdfHinge& hinge) {
  Actuator motor;
  motor.name = hinge.name;
  motor.lower = hinge.lower;
  motor.upper = hinge.upper;
  motor.max_velocity = hinge.max_velocity > 0 ? hinge.max_velocity : kUsualSpeed;
  motor.no_load_speed = motor.max_velocity;
  motor.max_torque = motor.stall_torque = std::max(0.0, hinge.max_torque);
  motor.efficiency = 1;
  motor.kp = kGainPerEffort * motor.stall_torque;
  motor.rotor_inertia = kInertiaPerEffort * motor.stall_torque;
  motor.kd = 1.4 * std::sqrt(1.5 * motor.kp * motor.rotor_inertia);
  return motor;
}

void assumeMotors(const UrdfRobot& urdf, RobotModel& model) {
  std::vector<std::string> free_hinges;
  std::vector<std::string> slow_hinges;
  for (const UrdfHinge& hinge : urdf.hinges) {
    if (!hinge.mimics.empty()) continue;
    if (model.actuators.size() == kMaxJoints) {
      throw InputError(complaint(urdf.file, hinge.line,
                                 "more than " + std::to_string(kMaxJoints) + " joints that move"));
    }
    model.actuators.push_back(assumeMotor(hinge));
    if (hinge.max_torque <= 0) free_hinges.push_back(hinge.name);
    if (hinge.max_velocity <= 0) slow_hinges.push_back(hinge.name);
  }
  connectHinges(urdf, model);
  std::ostringstream gains;
  gains << "motors after the URDF's limits: stall torque = effort, no-load speed = velocity, kp = "
        << kGainPerEffort << " effort per rad, rotor inertia " << kInertiaPerEffort
        << " effort, kd = 1.4 sqrt(1.5 kp J)";
  model.notes.push_back(gains.str());
  tell(model, "effort 0, so without a motor and turning freely", free_hinges);
  tell(model, "velocity 0, taken as 10 rad/s", slow_hinges);
}

void addPoint(int body, const Pose& X_BS, const Vec3& p_S, double radius, RobotModel& model) {
  model.contact_spheres.push_back({body, X_BS * p_S, radius});
}

// The points of a solid that meet a floor first.
void addContacts(int body, const Shape& shape, RobotModel& model) {
  const Pose& X_BS = shape.X_BS;
  const double half = 0.5 * shape.size.z();
  switch (shape.kind) {
    case Shape::Kind::Sphere:
      addPoint(body, X_BS, Vec3::Zero(), shape.size.x(), model);
      return;
    case Shape::Kind::Capsule:
      addPoint(body, X_BS, Vec3(0, 0, half), shape.size.x(), model);
      addPoint(body, X_BS, Vec3(0, 0, -half), shape.size.x(), model);
      return;
    case Shape::Kind::Box:
      for (const double x : {-0.5, 0.5}) {
        for (const double y : {-0.5, 0.5}) {
          for (const double z : {-0.5, 0.5}) {
            addPoint(body, X_BS, Vec3(x, y, z).cwiseProduct(shape.size), 0, model);
          }
        }
      }
      return;
    case Shape::Kind::Cylinder:
      for (int i = 0; i < kRimPoints; ++i) {
        const double turn = 2 * M_PI * i / kRimPoints;
        const Vec3 rim = shape.size.x() * Vec3(std::cos(turn), std::sin(turn), 0);
        addPoint(body, X_BS, rim + Vec3(0, 0, half), 0, model);
        addPoint(body, X_BS, rim - Vec3(0, 0, half), 0, model);
      }
      return;
    case Shape::Kind::Hull:
      for (const Vec3& corner : shape.hull->corners) addPoint(body, X_BS, corner, 0, model);
      return;
  }
}

void assumeContacts(RobotModel& model) {
  for (std::size_t b = 0; b < model.bodies.size(); ++b) {
    for (const Shape& shape : model.bodies[b].collisions) {
      addContacts(static_cast<int>(b), shape, model);
    }
  }
  model.notes.push_back(
      "meets the ground with its collision solids (spheres, corners, rims): no feet with sensors");
}

void assumeNeighbours(RobotModel& model) {
  for (std::size_t i = 1; i < model.bodies.size(); ++i) {
    const int beyond = model.bodies[static_cast<std::size_t>(model.bodies[i].parent)].parent;
    if (beyond >= 0) forbidContact(beyond, static_cast<int>(i), model);
  }
  model.notes.push_back("bodies with one other body between them do not touch each other");
}

void assumePosture(RobotModel& model) {
  Posture zero{"Zero", "Zero", JointArray<double>(model.jointCount())};
  std::vector<std::string> moved;
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    const Actuator& actuator = model.actuators[j];
    zero.angle[j] = std::clamp(0.0, actuator.lower, actuator.upper);
    if (zero.angle[j] != 0) moved.push_back(actuator.name);
  }
  model.start_posture = zero.name;
  model.postures.push_back(zero);
  tell(model, "starts with every joint at 0, but for these whose range is without it", moved);
}

}  // namespace

void assumeBody(const UrdfRobot& urdf, RobotModel& model) {
  model.body_type = model.name;
  model.version = "1";
  model.cycle = std::chrono::milliseconds(10);
  assumeBase(urdf, model);
  assumeSolids(model);
  assumeMotors(urdf, model);
  addDefaultGroups(model);
  assumeContacts(model);
  assumeNeighbours(model);
  assumePosture(model);
}

}  // namespace nao
