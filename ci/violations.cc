#include "ci/violations.h"

#include <algorithm>
#include <cmath>

#include "ci/sentence.h"

namespace nao::ci {
namespace {

using std::chrono_literals::operator""ms;

// Free choice: more than a joint's soft stop gives way under a Nao's own weight.
constexpr double kBeyond = 2 * M_PI / 180;  // [rad]
constexpr double kFaster = 0.01;            // [rad/s] beyond a joint's speed; a thousandth of any
constexpr Duration kSaturated = 100ms;      // free choice: longer than a landing's jolt
constexpr double kTouch = 1.0;              // [N] free choice: a tenth of an arm's weight

// Two sides of one contact of a robot with itself: each other's opposite, to the last bits.
bool isPair(const sim::TouchForce& a, const sim::TouchForce& b) {
  return a.robot == b.robot && a.body != b.body && (a.f_W + b.f_W).norm() < 1e-9 * a.f_W.norm();
}

std::string beyond(const std::string& joint, double angle, double limit) {
  return joint + " at " + shownDegrees(angle) + ", its limit is " + shownDegrees(limit);
}

}  // namespace

std::vector<Violation> ViolationFinder::look(
    runtime::Simulation& simulation,
    const std::vector<std::shared_ptr<const SensorFrame>>& sensors) {
  found_.clear();
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    if (sensors[i]) lookAtRobot(simulation, i, *sensors[i]);
  }
  return found_;
}

void ViolationFinder::lookAtRobot(runtime::Simulation& simulation, std::size_t robot,
                                  const SensorFrame& sensors) {
  robot_ = robot;
  const RobotModel& model = simulation.robot(robot).model();
  lookAtAngles(model, sensors);
  if (const auto state = simulation.robot(robot).ports()->state.get()) {
    lookAtSpeeds(model, *state);
  }
  lookAtMotors(simulation, model);
  lookAtContacts(simulation.world().contacts(), model);
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    if (sensors.overheating[j] == 0) continue;
    add("heat", model.actuators[j].name + " has " + shown(sensors.temperature[j]) + " deg C");
  }
}

void ViolationFinder::add(const char* kind, std::string text) {
  found_.push_back({robot_, kind, std::move(text)});
}

void ViolationFinder::lookAtAngles(const RobotModel& model, const SensorFrame& sensors) {
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    const Actuator& actuator = model.actuators[j];
    const double limit = std::clamp(sensors.angle[j], actuator.lower, actuator.upper);
    if (std::abs(sensors.angle[j] - limit) <= kBeyond) continue;
    add("joint_limit", beyond(actuator.name, sensors.angle[j], limit));
  }
  for (const CoupledLimit& limit : model.coupled_limits) {
    const auto [low, high] = limit.rangeAt(sensors.angle[limit.driver]);
    const double angle = sensors.angle[limit.limited];
    const double allowed = std::clamp(angle, low, high);
    if (std::abs(angle - allowed) <= kBeyond) continue;
    add("coupled_limit", beyond(model.actuators[index(limit.limited)].name, angle, allowed));
  }
}

void ViolationFinder::lookAtSpeeds(const RobotModel& model, const motion::MotionState& state) {
  Before& before = robots_[robot_];
  if (state.time == before.time) return;
  const double dt = toSeconds(state.time - before.time);
  const bool was_there = before.command.angle.size() == model.jointCount();
  for (std::size_t j = 0; was_there && j < model.jointCount(); ++j) {
    const Actuator& actuator = model.actuators[j];
    const bool stiff = before.command.stiffness[j] > 0 && state.command.stiffness[j] > 0;
    const double speed = std::abs(state.command.angle[j] - before.command.angle[j]) / dt;
    if (!stiff || actuator.coordinates.empty()) continue;
    if (speed <= actuator.max_velocity + kFaster) continue;
    add("velocity", actuator.name + " is asked for " + shownDegrees(speed) +
                        "/s, its top speed is " + shownDegrees(actuator.max_velocity) + "/s");
  }
  before.time = state.time;
  before.command = state.command;
}

void ViolationFinder::lookAtMotors(runtime::Simulation& simulation, const RobotModel& model) {
  const sim::World::Motors motors = simulation.world().motors(robot_);
  std::vector<SimTime>& free = robots_[robot_].free;
  free.resize(model.jointCount(), simulation.now());
  for (std::size_t j = 0; j < model.jointCount(); ++j) {
    if (!motors.saturated[j]) free[j] = simulation.now();
    if (simulation.now() - free[j] < kSaturated) continue;
    add("torque",
        model.actuators[j].name + " gives all it has, " + shown(motors.torque[j]) + " N m");
  }
}

void ViolationFinder::lookAtContacts(const sim::ContactReport& contacts, const RobotModel& model) {
  const auto& forces = contacts.forces;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    const bool mine = forces[i].robot == static_cast<int>(robot_);
    if (!mine || forces[i].f_W.norm() < kTouch) continue;
    for (std::size_t k = i + 1; k < forces.size(); ++k) {
      if (!isPair(forces[i], forces[k])) continue;
      const auto name = [&](int body) { return model.bodies[static_cast<std::size_t>(body)].name; };
      add("self_collision", name(forces[i].body) + " and " + name(forces[k].body) +
                                " push each other with " + shown(forces[i].f_W.norm()) + " N");
    }
  }
}

}  // namespace nao::ci
