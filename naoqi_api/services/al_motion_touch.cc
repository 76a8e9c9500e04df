#include "naoqi_api/services/al_motion_touch.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "naoqi_api/services/al_motion_names.h"
#include "naoqi_api/services/naoqi_method.h"

namespace nao::services {
namespace {

using rpc::Argument;
using rpc::Value;

constexpr double kBatteryVoltage = 21.6;  // [V] nominal: makes a torque constant of top speed
constexpr double kLoaded = 1.0;           // [N] above what soles read in the air; free
constexpr double kTouches = 0.01;         // [m] above the lowest point; free: solids are simple

// The point of a solid that is farthest along `down` (a unit vector), both in the solid's frame.
Vec3 farthestOf(const Shape& solid, const Vec3& down) {
  if (solid.kind == Shape::Kind::Hull) {
    const auto& corners = solid.hull->corners;
    return *std::max_element(corners.begin(), corners.end(), [&](const Vec3& a, const Vec3& b) {
      return a.dot(down) < b.dot(down);
    });
  }
  const auto towards = [](double half, double along) { return along < 0 ? -half : half; };
  if (solid.kind == Shape::Kind::Box) {
    return {towards(solid.size.x() / 2, down.x()), towards(solid.size.y() / 2, down.y()),
            towards(solid.size.z() / 2, down.z())};
  }
  const double radius = solid.size.x();
  if (solid.kind == Shape::Kind::Sphere) return radius * down;
  const Vec3 end(0, 0, towards(solid.size.z() / 2, down.z()));
  if (solid.kind == Shape::Kind::Capsule) return end + radius * down;
  const Vec3 aside(down.x(), down.y(), 0);
  return aside.norm() < 1e-9 ? end : Vec3(end + radius * aside.normalized());
}

}  // namespace

void AlMotionTouch::declare(rpc::Service& service) {
  addFunction(
      service, "_getTorque",
      [this](const Value& names, bool use_sensors) { return getTorques(names, use_sensors); },
      "The torques of joints about their axes [N m]: what the measured currents make, with the "
      "sign of where the command lies; or what the command asks of an ideal drive.",
      Argument{"names", "Name of a joint or chain, or a list of names."},
      Argument{"useSensor", "True: from the currents, false: from the command."})
      .at(265);
  addFunction(
      service, "_getGroundCollision", [this] { return getTouching(Which::All); },
      "[[link, [x, y, z]], ...] of what is down on the ground by measured joints and the inertial "
      "unit: its lowest point in the torso's frame [m].")
      .at(293);
  addFunction(
      service, "_getGroundCollisionForForceContact", [this] { return getLoadedSoles(); },
      "[[link, force], ...] of the feet that feel a load [N].")
      .at(294);
  addFunction(
      service, "_getGroundCollisionForFallManager", [this] { return getTouching(Which::ButFeet); },
      "As _getGroundCollision, without the feet: empty while the robot stands.")
      .at(295);
}

std::vector<float> AlMotionTouch::getTorques(const Value& names, bool use_sensors) const {
  std::vector<float> torques;
  for (const Joint joint : jointsNamed(link_.model(), readNames(names))) {
    torques.push_back(static_cast<float>(use_sensors ? feltTorque(joint) : commandedTorque(joint)));
  }
  return torques;
}

// The drive's proportional part, up to what its stiffness allows.
double AlMotionTouch::commandedTorque(Joint joint) const {
  const Actuator& actuator = link_.model().actuators[index(joint)];
  const auto state = link_.state();
  const double most =
      std::max(0.0, state->command.stiffness[joint]) * actuator.efficiency * actuator.stall_torque;
  const double gap = state->command.angle[joint] - link_.sensors()->angle[joint];
  return std::clamp(actuator.kp * gap, -most, most);
}

// A motor's current says how strong it pulls, not which way.
double AlMotionTouch::feltTorque(Joint joint) const {
  const Actuator& actuator = link_.model().actuators[index(joint)];
  if (actuator.no_load_speed <= 0) return 0;
  const double per_ampere = actuator.efficiency * kBatteryVoltage / actuator.no_load_speed;
  return std::copysign(per_ampere * link_.sensors()->current[joint], commandedTorque(joint));
}

bool AlMotionTouch::isFoot(int body) const {
  const auto& feet = link_.model().feet;
  return std::any_of(feet.begin(), feet.end(),
                     [body](const FootModel& foot) { return foot.body == body; });
}

Value AlMotionTouch::getLoadedSoles() const {
  const auto sensors = link_.sensors();
  std::vector<Value> loaded;
  for (std::size_t i = 0; i < link_.model().feet.size() && i < sensors->feet.size(); ++i) {
    const double force = sensors->feet[i].total;
    if (force < kLoaded) continue;
    const auto body = static_cast<std::size_t>(link_.model().feet[i].body);
    loaded.push_back(Value::list({link_.model().bodies[body].name, static_cast<float>(force)}));
  }
  return Value::list(std::move(loaded));
}

AlMotionTouch::LowPoint AlMotionTouch::lowestOf(int body, const Vec3& down) const {
  const RobotModel& model = link_.model();
  LowPoint lowest{body, Vec3::Zero(), -std::numeric_limits<double>::infinity()};
  const auto look = [&](const Vec3& p_T) {
    const double depth = p_T.dot(down);
    if (depth > lowest.depth) lowest = {body, p_T, depth};
  };
  for (const Shape& solid : model.bodies[static_cast<std::size_t>(body)].collisions) {
    const Pose X_TS = kinematics_.getPose(body) * solid.X_BS;
    look(X_TS * farthestOf(solid, X_TS.linear().transpose() * down));
  }
  for (const FootModel& foot : model.feet) {
    if (foot.body != body) continue;
    const Pose X_TS = kinematics_.calcPose({foot.body, foot.X_BS});
    for (const auto& corner : foot.outline) look(X_TS * Vec3(corner.x(), corner.y(), 0));
  }
  return lowest;
}

Value AlMotionTouch::getTouching(Which which) {
  const auto sensors = link_.sensors();
  kinematics_.update(sensors->angle);
  const Mat3 R_WT = rotationFromRpy(sensors->angle_x, sensors->angle_y, 0);
  const Vec3 down = R_WT.transpose() * -Vec3::UnitZ();  // in T
  std::vector<LowPoint> points;
  for (int body = 0; body < static_cast<int>(link_.model().bodies.size()); ++body) {
    points.push_back(lowestOf(body, down));
  }
  const double ground =
      std::max_element(points.begin(), points.end(), [](const LowPoint& a, const LowPoint& b) {
        return a.depth < b.depth;
      })->depth;
  std::vector<Value> touching;
  for (const LowPoint& point : points) {
    if (point.depth < ground - kTouches) continue;
    if (which == Which::ButFeet && isFoot(point.body)) continue;
    const Vec3& p = point.p_T;
    const std::string& name = link_.model().bodies[static_cast<std::size_t>(point.body)].name;
    touching.push_back(
        Value::list({name, Value::list({static_cast<float>(p.x()), static_cast<float>(p.y()),
                                        static_cast<float>(p.z())})}));
  }
  return Value::list(std::move(touching));
}

}  // namespace nao::services
