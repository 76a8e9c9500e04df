#include "walk_engine/servo_lead.h"

#include <algorithm>
#include <utility>

namespace nao::walk {
namespace {

const Vec3 kGravity(0, 0, -9.80665);  // [m/s^2] in O

}  // namespace

ServoLead::ServoLead(std::shared_ptr<const RobotModel> model)
    : model_(std::move(model)),
      half_cycle_(0.5 * toSeconds(model_->cycle)),
      torque_(model_->jointCount(), 0.0),
      last_(model_->jointCount(), 0.0) {
  for (std::size_t i = 0; i < 2; ++i) {
    for (int body = model_->feet[i].body; body > 0;
         body = model_->bodies[static_cast<std::size_t>(body)].parent) {
      const auto b = static_cast<std::size_t>(body);
      legs_[i].push_back({b, model_->coordinates[b - 1].joint});
    }
  }
}

// From the sole up, so that each hinge finds the moment of everything below it summed already.
void ServoLead::addTorques(const motion::Kinematics& body, const Pose& X_OT, const FootLoad& load,
                           const std::vector<Link>& leg) {
  Vec3 force = load.force;                   // [N] on what hangs below the hinge
  Vec3 moment = load.p_O.cross(load.force);  // [N m] about the origin of O
  for (const Link& link : leg) {
    const Body& part = model_->bodies[link.body];
    const Pose X_OB = X_OT * body.getPose(static_cast<int>(link.body));
    const Vec3 weight = part.mass * kGravity;
    force += weight;
    moment += (X_OB * part.p_BoBcm).cross(weight);
    const Vec3 about_hinge = moment - X_OB.translation().cross(force);
    torque_[link.joint] -= about_hinge.dot(X_OB.linear() * part.axis);
  }
}

void ServoLead::apply(const motion::Kinematics& body, const Pose& X_OT,
                      const std::array<FootLoad, 2>& loads, JointArray<double>& angle) {
  torque_ = JointArray<double>(model_->jointCount(), 0.0);
  for (std::size_t i = 0; i < 2; ++i) addTorques(body, X_OT, loads[i], legs_[i]);
  const JointArray<double> planned = angle;
  for (const auto& leg : legs_) {
    for (const Link& link : leg) {
      const Actuator& motor = model_->actuators[index(link.joint)];
      if (motor.kp <= 0) continue;
      const double way = moving_ ? planned[link.joint] - last_[link.joint] : 0;  // [rad] a cycle
      const double speed = way / (2 * half_cycle_);
      const double lead =
          speed * (motor.kd / motor.kp + half_cycle_) + torque_[link.joint] / motor.kp;
      angle[link.joint] = std::clamp(planned[link.joint] + lead, motor.lower, motor.upper);
    }
  }
  last_ = planned;
  moving_ = true;
}

}  // namespace nao::walk
