#include "walk_engine/servo_lead.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace nao::walk {
namespace {

const Vec3 kGravity(0, 0, -9.80665);  // [m/s^2] in O

// [N m] Below this a motor is taken to be between the two ends of its play. Measured: from 1 down
// to this the walk gets truer.
constexpr double kTurning = 0.002;

// Half the play [rad] of each gear, as the robot's file documents it.
JointArray<double> halfPlay(const RobotModel& model) {
  JointArray<double> half(model.jointCount(), 0.0);
  for (const EffectSetting& effect : model.effects) {
    const auto width = effect.parameters.find("width");
    if (effect.name != "backlash" || width == effect.parameters.end()) continue;
    for (const Joint joint : effect.joints) half[joint] += width->second / 2;
  }
  return half;
}

}  // namespace

ServoLead::ServoLead(std::shared_ptr<const RobotModel> model)
    : model_(std::move(model)),
      dt_(toSeconds(model_->cycle)),
      half_play_(halfPlay(*model_)),
      torque_(model_->jointCount(), 0.0) {
  for (std::size_t i = 0; i < 2; ++i) {
    for (int body = model_->feet[i].body; body > 0;
         body = model_->bodies[static_cast<std::size_t>(body)].parent) {
      const auto b = static_cast<std::size_t>(body);
      legs_[i].push_back({b, model_->coordinates[b - 1].joint});
    }
  }
}

void ServoLead::plan(const JointArray<double>& angle, const motion::Kinematics& body,
                     const Pose& X_OT, std::array<bool, 2> stands, bool resting) {
  newest_ = (newest_ + 1) % 3;
  PlannedPose& newest = plans_[newest_];
  newest.angle = angle;
  newest.stands = stands;
  newest.X_OB.resize(model_->bodies.size());
  for (std::size_t b = 0; b < newest.X_OB.size(); ++b) {
    newest.X_OB[b] = X_OT * body.getPose(static_cast<int>(b));
  }
  if (!resting) return;
  for (PlannedPose& plan : plans_) plan = newest;
}

// The force [N] a body's acceleration and weight ask for.
Vec3 ServoLead::calcNeed(std::size_t body) const {
  const Body& part = model_->bodies[body];
  const Vec3 p = now().X_OB[body] * part.p_BoBcm;
  const Vec3 last = before().X_OB[body] * part.p_BoBcm;
  const Vec3 next = after().X_OB[body] * part.p_BoBcm;
  return part.mass * ((next - 2 * p + last) / (dt_ * dt_) - kGravity);
}

ServoLead::Wrench ServoLead::calcGround() const {
  Wrench ground;
  for (std::size_t b = 0; b < model_->bodies.size(); ++b) {
    const Vec3 need = calcNeed(b);
    ground.force += need;
    ground.moment += (now().X_OB[b] * model_->bodies[b].p_BoBcm).cross(need);
  }
  return ground;
}

// In single support one foot takes all. In double support the feet share by where the pressure is
// between them, and each gets the same moment about its own sole per newton.
std::array<ServoLead::Wrench, 2> ServoLead::shareGround(const Wrench& ground) const {
  const PlannedPose& plan = now();
  if (!plan.stands[0]) return {Wrench{}, ground};
  if (!plan.stands[1]) return {ground, Wrench{}};
  std::array<Vec3, 2> sole;
  for (std::size_t i = 0; i < 2; ++i) {
    const FootModel& foot = model_->feet[i];
    sole[i] = (plan.X_OB[static_cast<std::size_t>(foot.body)] * foot.X_BS).translation();
  }
  const Vec3 pressure(-ground.moment.y() / ground.force.z(), ground.moment.x() / ground.force.z(),
                      0);
  const Vec3 across = sole[0] - sole[1];
  const double left = std::clamp((pressure - sole[1]).dot(across) / across.squaredNorm(), 0.0, 1.0);
  const Vec3 centre = sole[1] + left * across;
  const Vec3 rest = ground.moment - centre.cross(ground.force);
  std::array<Wrench, 2> shares;
  for (std::size_t i = 0; i < 2; ++i) {
    const double part = i == 0 ? left : 1 - left;
    shares[i].force = part * ground.force;
    shares[i].moment = sole[i].cross(shares[i].force) + part * rest;
  }
  return shares;
}

// From the sole up: what acts on everything below a hinge, less what that needs, is left for the
// motor to balance.
void ServoLead::addTorques(Wrench wrench, const std::vector<Link>& leg) {
  for (const Link& link : leg) {
    const Body& part = model_->bodies[link.body];
    const Pose& X_OB = now().X_OB[link.body];
    const Vec3 need = calcNeed(link.body);
    wrench.force -= need;
    wrench.moment -= (X_OB * part.p_BoBcm).cross(need);
    const Vec3 about_hinge = wrench.moment - X_OB.translation().cross(wrench.force);
    torque_[link.joint] -= about_hinge.dot(X_OB.linear() * part.axis);
  }
}

void ServoLead::apply(JointArray<double>& angle) {
  torque_ = JointArray<double>(model_->jointCount(), 0.0);
  const std::array<Wrench, 2> shares = shareGround(calcGround());
  for (std::size_t i = 0; i < 2; ++i) addTorques(shares[i], legs_[i]);
  for (const auto& leg : legs_) {
    for (const Link& link : leg) {
      const Joint joint = link.joint;
      const Actuator& motor = model_->actuators[index(joint)];
      angle[joint] = now().angle[joint];
      if (motor.kp <= 0) continue;
      const double speed = (after().angle[joint] - before().angle[joint]) / (2 * dt_);
      const double torque = torque_[joint];
      angle[joint] += speed * (motor.kd / motor.kp + dt_ / 2) + torque / motor.kp;
      angle[joint] += half_play_[joint] * torque / std::hypot(torque, kTurning);
      angle[joint] = std::clamp(angle[joint], motor.lower, motor.upper);
    }
  }
}

void ServoLead::archive(Archive& archive) {
  for (PlannedPose& plan : plans_) {
    archive.value(plan.angle);
    archive.each(plan.X_OB, [&archive](Pose& X_OB) { archive.numbers(X_OB.matrix()); });
    archive.value(plan.stands);
  }
  archive.value(newest_);
}

}  // namespace nao::walk
