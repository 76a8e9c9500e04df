#include "validation/play_faults.h"

#include <algorithm>
#include <cmath>

namespace nao::validation {
namespace {

using Kind = motion::MotionFault::Kind;

constexpr double kDegree = M_PI / 180;
// A robot is upright below the one and down beyond the other. Free choice: a Nao leans by up to
// 35 degrees when it sits down or kicks, and none that tilts by 60 comes back.
constexpr double kUpright = 45 * kDegree;
constexpr double kDown = 60 * kDegree;
constexpr double kTouch = 0.5;  // [N] free choice: a twentieth of an arm's weight

// Two sides of one contact: forces that are each other's opposite, to the last bits.
bool isPair(const sim::TouchForce& a, const sim::TouchForce& b) {
  return a.robot == 0 && b.robot == 0 && a.body != b.body &&
         (a.f_W + b.f_W).norm() < 1e-9 * a.f_W.norm();
}

}  // namespace

PlayFaults::PlayFaults(const RobotModel& model)
    : model_(model), saturated_steps_(model.jointCount(), 0) {}

void PlayFaults::look(const sim::World& world, double time) {
  lookAtPosture(world.scene().robots[0].X_WB[0], time);
  lookAtMotors(world, time);
  lookAtContacts(world, time);
}

void PlayFaults::lookAtPosture(const Pose& X_WT, double time) {
  tilt_ = std::acos(std::clamp(X_WT.linear()(2, 2), -1.0, 1.0));
  if (tilt_ < kUpright) upright_ = true;
  if (!upright_ || tilt_ < kDown || model_.fixed_base) return;
  upright_ = false;
  fell_ = true;
  log_.add({Kind::Fall, {}, time, tilt_, kDown, {}});
}

void PlayFaults::lookAtMotors(const sim::World& world, double time) {
  const sim::World::Motors motors = world.motors(0);
  const auto cycle = static_cast<int>(model_.cycle / world.stepSize());
  for (std::size_t j = 0; j < model_.jointCount(); ++j) {
    saturated_steps_[j] = motors.saturated[j] ? saturated_steps_[j] + 1 : 0;
    if (saturated_steps_[j] < cycle) continue;
    log_.add({Kind::Torque, toJoint(j), time, std::abs(motors.torque[j]), 0, {}});
  }
}

void PlayFaults::lookAtContacts(const sim::World& world, double time) {
  const auto& forces = world.contacts().forces;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    if (forces[i].f_W.norm() < kTouch) continue;
    for (std::size_t k = i + 1; k < forces.size(); ++k) {
      if (!isPair(forces[i], forces[k])) continue;
      const int a = std::min(forces[i].body, forces[k].body);
      const int b = std::max(forces[i].body, forces[k].body);
      // The joint that moves the body further out, by NaoQi's name.
      const Joint joint = model_.coordinates[static_cast<std::size_t>(b - 1)].joint;
      const std::string pair = model_.bodies[static_cast<std::size_t>(a)].name + " and " +
                               model_.bodies[static_cast<std::size_t>(b)].name;
      log_.add({Kind::Collision, joint, time, forces[i].f_W.norm(), 0, pair});
    }
  }
}

}  // namespace nao::validation
