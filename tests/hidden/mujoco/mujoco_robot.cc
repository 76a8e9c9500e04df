#include "tests/hidden/mujoco/mujoco_robot.h"

#include <algorithm>
#include <functional>
#include <map>

#include "core/check.h"

namespace nao::hidden {
namespace {

constexpr double kShut = 0.01;  // [rad] that stops leave at least: MuJoCo ends the program without

/// One number of an effect, at one joint or, where it acts on the whole robot, at none.
struct Change {
  MujocoRobot& robot;
  std::size_t joint;
  double value;

  MujocoJoint& motor() const { return robot.joints[joint]; }
  Coordinate& hinge() const {
    return robot.model.coordinates[static_cast<std::size_t>(motor().coordinates.front())];
  }
  Body& link() const {
    return robot.model.bodies[static_cast<std::size_t>(motor().coordinates.front()) + 1];
  }
};
using Act = std::function<void(const Change&)>;

void tilt(const Change& change, const Vec3& axis) {
  Pose& X_WB = change.robot.model.bodies[0].X_PB;
  X_WB.linear() = Eigen::AngleAxisd(change.value, axis) * X_WB.linear();
}

// "effect.parameter" and what it does: above what the nominal models have, below what is hidden.
const std::map<std::string, Act>& jointActs() {
  static const std::map<std::string, Act> kActs{
      {"backlash.width", [](const Change& c) { c.motor().play += c.value; }},
      {"command_latency.delay", [](const Change& c) { c.motor().order_delay += c.value; }},
      {"sensor_delay.delay", [](const Change& c) { c.motor().report_delay += c.value; }},
      {"encoder_quantum.quantum", [](const Change& c) { c.motor().quantum = c.value; }},
      {"encoder_offset.angle", [](const Change& c) { c.motor().turned += c.value; }},
      {"process_noise.sd", [](const Change& c) { c.motor().noise_sd = c.value; }},
      {"process_noise.time", [](const Change& c) { c.motor().noise_time = c.value; }},

      {"mujoco_friction_loss.torque", [](const Change& c) { c.motor().friction_loss += c.value; }},
      {"mujoco_damping.coefficient", [](const Change& c) { c.motor().damping += c.value; }},
      {"mujoco_armature.part", [](const Change& c) { c.motor().armature *= 1 + c.value; }},
      {"mujoco_range.lower",
       [](const Change& c) {
         c.hinge().lower = std::min(c.hinge().lower + c.value, c.hinge().upper - kShut);
       }},
      {"mujoco_range.upper",
       [](const Change& c) {
         c.hinge().upper = std::max(c.hinge().upper + c.value, c.hinge().lower + kShut);
       }},
      {"mujoco_delay.delay", [](const Change& c) { c.motor().order_delay += c.value; }},
      {"mujoco_late_report.delay", [](const Change& c) { c.motor().report_delay += c.value; }},
      {"mujoco_filter.time", [](const Change& c) { c.motor().order_filter += c.value; }},
      {"mujoco_gain.part", [](const Change& c) { c.motor().kp *= 1 + c.value; }},
      {"mujoco_derivative.part", [](const Change& c) { c.motor().kd *= 1 + c.value; }},
      {"mujoco_weakness.part", [](const Change& c) { c.motor().strength *= 1 + c.value; }},
      {"mujoco_play.width", [](const Change& c) { c.motor().play += c.value; }},
      {"mujoco_turned_encoder.angle", [](const Change& c) { c.motor().turned += c.value; }},
      {"mujoco_spring.stiffness", [](const Change& c) { c.motor().spring += c.value; }},
      {"mujoco_bias.torque", [](const Change& c) { c.motor().bias += c.value; }},
      {"mujoco_mass.part",
       [](const Change& c) {
         c.link().mass *= 1 + c.value;
         c.link().I_Bcm *= 1 + c.value;
       }},
  };
  return kActs;
}

const std::map<std::string, Act>& robotActs() {
  static const std::map<std::string, Act> kActs{
      {"mujoco_gravity.part", [](const Change& c) { c.robot.gravity *= 1 + c.value; }},
      {"mujoco_tilt.x", [](const Change& c) { tilt(c, Vec3::UnitX()); }},
      {"mujoco_tilt.y", [](const Change& c) { tilt(c, Vec3::UnitY()); }},
  };
  return kActs;
}

MujocoJoint motorOf(const Actuator& actuator) {
  MujocoJoint motor;
  motor.coordinates = actuator.coordinates;
  motor.kp = actuator.kp;
  motor.kd = actuator.kd;
  motor.strength = actuator.efficiency * actuator.stall_torque;
  motor.top_speed = actuator.no_load_speed;
  motor.armature = actuator.rotor_inertia;
  return motor;
}

void apply(const EffectSetting& setting, MujocoRobot& robot) {
  for (const auto& [parameter, value] : setting.parameters) {
    const std::string name = setting.name + "." + parameter;
    if (const auto act = robotActs().find(name); act != robotActs().end()) {
      act->second({robot, 0, value});
      continue;
    }
    const auto act = jointActs().find(name);
    if (act == jointActs().end()) throw InputError("MuJoCo as reality: no law for " + name);
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      const auto& some = setting.joints;
      const bool here =
          some.empty() || std::find(some.begin(), some.end(), toJoint(j)) != some.end();
      if (here && !robot.joints[j].coordinates.empty()) act->second({robot, j, value});
    }
  }
}

}  // namespace

MujocoRobot makeMujocoRobot(const RobotModel& model, const std::vector<EffectSetting>& extra) {
  NAO_CHECK(model.fixed_base);
  MujocoRobot robot{model, {}};
  for (const Actuator& actuator : model.actuators) robot.joints.push_back(motorOf(actuator));
  for (const EffectSetting& setting : model.effects) apply(setting, robot);
  for (const EffectSetting& setting : extra) apply(setting, robot);
  return robot;
}

}  // namespace nao::hidden
