#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/world_model.h"
#include "sim/effects/catalogue.h"
#include "sim/robot_body.h"
#include "tests/support/models.h"

namespace nao::sim::test {

/// Effects as a robot's file lists them, on all joints.
inline EffectSetting effect(const std::string& name,
                            std::map<std::string, double> parameters = {}) {
  return {name, std::move(parameters), {}, ""};
}
/// On one joint.
inline EffectSetting effectOn(std::size_t joint, const std::string& name,
                              std::map<std::string, double> parameters = {}) {
  return {name, std::move(parameters), {toJoint(joint)}, ""};
}

/// The effects `settings` of `model`, as a world would make them.
inline EffectChain chainOf(const RobotModel& model, const std::vector<EffectSetting>& settings,
                           std::uint64_t seed = 1, Duration step = std::chrono::milliseconds(2)) {
  return EffectChain(standardEffects(), settings, model, step, seed, "dut");
}

/// The pendulum of tests/support with a motor that does nothing: kp = kd = stall torque = 0. Its
/// rod lies along x; gravity pulls it to larger angles.
inline std::shared_ptr<RobotModel> freeRod(double mass, double length) {
  auto model = nao::test::pendulum(mass, length);
  model->actuators[0].kp = model->actuators[0].kd = model->actuators[0].stall_torque = 0;
  return model;
}

/// One robot with its effects, without sensors: what WorldRobot does in a step, with the truth
/// open.
class Rig {
 public:
  Rig(std::shared_ptr<const RobotModel> model, const std::vector<EffectSetting>& effects,
      double gravity = 0, double step = 0.001)
      : model_(std::move(model)),
        step_(step),
        effects_(chainOf(*model_, effects, 1, fromSeconds(step))),
        body_(planOf(gravity)) {
    command.angle = JointArray<double>(model_->jointCount());
    command.stiffness = JointArray<double>(model_->jointCount(), 1.0);
  }

  void run(double seconds) {
    for (long left = std::lround(seconds / step_); left > 0; --left) step();
  }

  void step() {
    JointCommand followed = command;
    effects_.alterCommand(followed, now_, step_);
    const Drive& drive = body_.drive();
    effects_.alterDrive({now_, step_, drive.angle(), drive.rate(), followed.angle,
                         followed.stiffness, drive.torque(), drive.load()},
                        terms_);
    if (pull != 0) terms_.disturbance[0] += pull;
    body_.step(followed, &terms_, {}, step_);
    now_ += fromSeconds(step_);
  }

  /// The root's speeds come first, for a robot that is free.
  void setSpeed(int i, double speed) {
    TreeState tree = body_.tree();
    tree.u[i] = speed;
    body_.setTree(tree);
  }

  RobotBody& body() { return body_; }
  double angle() const { return body_.tree().q[0]; }          // [rad] of the rod
  double rate() const { return body_.tree().u[0]; }           // [rad/s] of the rod
  double encoder() const { return body_.angle(toJoint(0)); }  // [rad]
  double motorTorque() const { return body_.drive().torque()[0]; }
  const BodyPlan& plan() const { return body_.plan(); }

  JointCommand command;
  double pull = 0;  // [N m] on the rod

 private:
  BodyPlan planOf(double gravity) {
    WorldModel world;
    world.gravity = gravity;
    BodyPlan plan(*model_, world);
    effects_.alterPlan(plan);
    return plan;
  }

  std::shared_ptr<const RobotModel> model_;
  double step_;  // [s]
  EffectChain effects_;
  RobotBody body_;
  DriveTerms terms_;
  SimTime now_{};
};

}  // namespace nao::sim::test
