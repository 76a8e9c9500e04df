#include "sim/geared_motor.h"

#include <algorithm>
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

// What the gear of a motor without current holds, as a part of its stall torque. Estimate: a Nao
// switched off in Crouch stays there, which takes 3 %. It is the gear's losses that hold: none in a
// robot whose file takes them for part of the motor, and leaves friction to be found.
constexpr double kHold = 0.05;
constexpr double kUsualEfficiency = 0.7;  // of a Nao's gear
// [N m s/rad] The creep of a held joint: 0.4 N m would turn it by 1 degree in 12 hours.
constexpr double kRest = 1e6;
// [N m/rad] A gear with play alone touches as hard as a joint's stop: 3 N m bend it 0.01 degrees.
constexpr double kHardGear = 2e4;
// The duty of one step of the pulse width, 1/885 in a Dynamixel XL330 (data sheet): less is none.
constexpr double kLeastDuty = 1.0 / 885;
constexpr int kChanges = 2;  // of mind within one step, so that a step always ends

}  // namespace

GearedMotor::GearedMotor(const BodyPlan& plan, std::size_t joint)
    : GearedMotor(plan.model.actuators[joint], plan.transmissions[joint]) {
  deadband_ = plan.servo_deadband[joint];
  deadband_ease_ = plan.servo_deadband_ease[joint];
  duty_root_ = plan.duty_root[joint];
  torque_part_ = plan.torque_part[joint];
  zero_ = plan.joint_zero[joint];
}

GearedMotor::GearedMotor(const Actuator& a, const Transmission& gear)
    : kp_(a.kp),
      kd_(a.kd),
      stall_(a.stall_torque),
      efficiency_(a.efficiency),
      no_load_(a.no_load_speed),
      rotor_(a.rotor_inertia),
      hold_(kHold * (1 - a.efficiency) / (1 - kUsualEfficiency)),
      soft_(gear.play > 0 || gear.stiffness > 0),
      half_play_(gear.play / 2),
      stiffness_(gear.stiffness > 0 ? gear.stiffness : kHardGear),
      damping_(gear.stiffness > 0 ? gear.damping : 2 * std::sqrt(kHardGear * a.rotor_inertia)) {}

void GearedMotor::Input::take(const DriveTerms& terms, std::size_t joint) {
  resist_forward = terms.resist_forward[joint];
  resist_backward = terms.resist_backward[joint];
  creep_forward = terms.creep_forward[joint];
  creep_backward = terms.creep_backward[joint];
  creep_slope = terms.creep_slope[joint];
  viscous = terms.viscous[joint];
  torque_part = terms.torque_part[joint];
  speed_part = terms.speed_part[joint];
  disturbance = terms.disturbance[joint];
}

void GearedMotor::reset(double q) {
  angle_ = q;
  rate_ = 0;
  grip_ = Grip::Stuck;
  torque_ = load_ = 0;
}

void GearedMotor::observe(double q, double u) {
  if (soft_) return;
  angle_ = q;
  rate_ = u;
}

void GearedMotor::prepare(const Input& input) {
  h_ = input.h;
  observe(input.q, input.u);
  grip_changes_ = side_changes_ = 0;
  disturbance_ = input.disturbance;
  prepareServo(input);
  prepareFriction(input);
  prepareGear(input);
  combine();
}

void GearedMotor::prepareServo(const Input& input) {
  saturated_ = false;
  const double stiffness = std::min(input.stiffness, 1.0);
  if (stiffness <= 0) {
    servo_ = servo_change_ = limit_up_ = limit_down_ = 0;
    return;
  }
  double error = input.command - angle();
  double kp = kp_;
  if (deadband_ > 0 && deadband_ease_ > 0) {
    error = easedError(error, kp);
  } else if (deadband_ > 0) {
    if (std::abs(error) <= deadband_) kp = 0;
    error -= std::copysign(std::min(std::abs(error), deadband_), error);
  }
  double torque = kp_ * error;  // kp: its slope
  if (duty_root_ > 0 && kp > 0) bendServo(error, torque, kp);
  servo_ = torque - (kp * h_ + kd_) * rate_;
  servo_change_ = kp * h_ + kd_;
  const double limit = stiffness * efficiency_ * stall_ * torque_part_ * input.torque_part;
  const double ratio = rate_ / (no_load_ * std::max(input.speed_part, 1e-3));
  limit_up_ = limit * std::clamp(1 - ratio, 0.0, 1.0);
  limit_down_ = limit * std::clamp(1 + ratio, 0.0, 1.0);
}

// A hyperbola between nothing and the line beyond the dead band, from 0 at 0 on.
double GearedMotor::easedError(double error, double& slope) const {
  const double off = std::abs(error) - deadband_, bend = deadband_ease_ * deadband_;
  const double root = std::hypot(off, bend), first = std::hypot(deadband_, bend);
  slope *= (1 + off / root) / 2;
  return std::copysign((off + root - (first - deadband_)) / 2, error);
}

// A line up to the smallest duty, where the root has no slope; all of it beyond full duty.
void GearedMotor::bendServo(double error, double& torque, double& slope) const {
  const double most = efficiency_ * stall_;
  const double duty = std::abs(kp_ * error) / std::max(most, 1e-9);
  if (duty >= 1) return;
  const double root = std::sqrt(std::max(duty, kLeastDuty));
  const double part = duty < kLeastDuty ? duty / root : root;
  const double rise = duty < kLeastDuty ? 1 / root : 0.5 / root;
  torque = (1 - duty_root_) * torque + duty_root_ * std::copysign(most * part, error);
  slope *= 1 - duty_root_ + duty_root_ * rise;
}

void GearedMotor::prepareFriction(const Input& input) {
  resist_forward_ = input.resist_forward;
  resist_backward_ = input.resist_backward;
  viscous_ = input.viscous;
  if (input.stiffness <= 0) {
    resist_forward_ += hold_ * stall_;
    resist_backward_ += hold_ * stall_;
    if (!input.open && no_load_ > 0) viscous_ += stall_ / no_load_;
  } else if (servo_ > limit_up_ || servo_ < -limit_down_) {
    // A load that drives the motor loses in the gear, too, as large a part as the motor does that
    // drives the load: it yields at torque / efficiency, where it gives torque * efficiency. Four
    // stages that take 0.7 from the motor by the friction of their teeth take 0.68 from the load.
    const double part = std::min(input.stiffness, 1.0) * torque_part_ * input.torque_part;
    const double held = part * stall_ * (1 / efficiency_ - efficiency_);
    (servo_ > 0 ? resist_backward_ : resist_forward_) += held;
  }
  rest_ = resist_forward_ > 0 || resist_backward_ > 0 ? kRest : input.creep_slope;
  resist_forward_ += input.creep_forward;
  resist_backward_ += input.creep_backward;
  if (resist_forward_ <= 0 && resist_backward_ <= 0) {
    grip_ = Grip::None;
  } else if (grip_ == Grip::None) {
    grip_ = Grip::Stuck;
  }
  if (grip_ == Grip::Sliding && !slidesAt(rate_)) grip_ = Grip::Stuck;
  if (grip_ == Grip::Sliding) slide(rate_);
}

// Whether friction is at its budget at this rate, as it slides.
bool GearedMotor::slidesAt(double rate) const {
  const double budget = rate > 0 ? resist_forward_ : resist_backward_;
  return rate != 0 && rest_ * std::abs(rate) >= budget;
}

void GearedMotor::slide(double direction) {
  grip_ = Grip::Sliding;
  slide_ = direction > 0 ? -resist_forward_ : resist_backward_;
}

double GearedMotor::frictionNow() const {
  if (grip_ == Grip::Stuck) return -frictionChange() * rate_;
  return (grip_ == Grip::Sliding ? slide_ : 0) - viscous_ * rate_;
}

double GearedMotor::frictionChange() const {
  if (grip_ != Grip::Stuck) return viscous_;
  return rest_ == kRest ? kRest : rest_ + viscous_;
}

void GearedMotor::prepareGear(const Input& input) {
  if (!soft_) return;
  closing_ = rate_ - input.u;
  gap_ = angle_ - input.q + h_ * closing_;
  engage(gap_ > half_play_ ? 1 : gap_ < -half_play_ ? -1 : 0);
}

void GearedMotor::engage(int side) {
  side_ = side;
  if (side == 0 && half_play_ > 0) {
    gear_ = gear_change_ = 0;
    return;
  }
  gear_ = stiffness_ * (gap_ - side * half_play_) + damping_ * closing_;
  gear_change_ = h_ * stiffness_ + damping_;
}

void GearedMotor::combine() {
  const double torque = servo_ + frictionNow();
  const double fall = servo_change_ + frictionChange();
  now_ = torque + disturbance_;
  change_ = fall;
  if (!soft_) return;
  const double inertia = rotor_ + h_ * (fall + gear_change_);
  from_rotor_ = h_ * (torque - gear_) / inertia;
  from_link_ = h_ * gear_change_ / inertia;
  now_ = gear_ + gear_change_ * from_rotor_ + disturbance_;
  change_ = gear_change_ * (1 - from_link_);
}

double GearedMotor::smoothTorque() const {
  return std::clamp(servo_, -limit_down_, limit_up_) - viscous_ * rate_;
}

bool GearedMotor::revise(double du) {
  const double dw = rotorChange(du);
  const bool servo = reviseServo(dw);
  const bool friction = reviseFriction(dw);
  const bool gear = soft_ && half_play_ > 0 && reviseGear(dw, du);
  if (!(servo || friction || gear)) return false;
  combine();
  return true;
}

bool GearedMotor::reviseServo(double dw) {
  if (saturated_) return false;
  const double torque = servo_ - servo_change_ * dw;
  if (torque <= limit_up_ && torque >= -limit_down_) return false;
  servo_ = torque > 0 ? limit_up_ : -limit_down_;
  servo_change_ = 0;
  return saturated_ = true;
}

bool GearedMotor::reviseFriction(double dw) {
  if (grip_ == Grip::None || grip_changes_ >= kChanges) return false;
  const double rate = rate_ + dw;  // at the end of the step
  if (grip_ == Grip::Stuck) {
    const double needed = -rest_ * rate;
    if (needed <= resist_backward_ && needed >= -resist_forward_) return false;
    slide(rate);
  } else {
    if (slide_ * rate <= 0 && slidesAt(rate)) return false;
    grip_ = Grip::Stuck;
  }
  ++grip_changes_;
  return true;
}

bool GearedMotor::reviseGear(double dw, double du) {
  if (side_changes_ >= kChanges) return false;
  if (side_ == 0) {
    const double gap = gap_ + h_ * (dw - du);
    if (std::abs(gap) <= half_play_) return false;
    engage(gap > 0 ? 1 : -1);
  } else {
    const double torque = gear_ + gear_change_ * (dw - du);
    if (side_ * torque >= 0) return false;
    engage(0);
  }
  ++side_changes_;
  return true;
}

void GearedMotor::finish(double du) {
  const double dw = rotorChange(du);
  torque_ = servo_ - servo_change_ * dw;
  if (!soft_) {
    load_ = now_ - disturbance_ - change_ * du - rotor_ * du / h_;
    return;
  }
  load_ = gear_ + gear_change_ * (dw - du);
  rate_ += dw;
  angle_ += h_ * rate_;
}

void GearedMotor::archive(Archive& archive) {
  archive.value(angle_);
  archive.value(rate_);
  archive.value(grip_);
  archive.value(torque_);
  archive.value(load_);
}

}  // namespace nao::sim
