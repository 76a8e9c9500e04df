#include "tests/hidden/mujoco/motor.h"

#include <algorithm>
#include <cmath>

namespace nao::hidden {
namespace {

std::size_t slots(double delay, double step) {
  return static_cast<std::size_t>(std::ceil(delay / step)) + 2;
}

void push(std::deque<double>& line, double value) {
  line.push_front(value);
  line.pop_back();
}

}  // namespace

MujocoMotor::MujocoMotor(const MujocoJoint& joint, double step, Random random)
    : joint_(joint), h_(step), random_(random) {
  // A semi-implicit step moves by the rate at its end: half a step early.
  joint_.order_delay += step / 2;
  if (joint.noise_sd <= 0) return;
  keep_ = std::exp(-step / joint.noise_time);
  fresh_ = joint.noise_sd * std::sqrt(1 - keep_ * keep_);
  noise_ = joint.noise_sd * random_.normal();
}

void MujocoMotor::reset(double angle) {
  ordered_ = followed_ = angle;
  orders_.assign(slots(joint_.order_delay, h_), angle);
  readings_.assign(slots(joint_.report_delay, h_), angle + joint_.turned);
}

double MujocoMotor::late(const std::deque<double>& line, double steps) {
  const auto whole = static_cast<std::size_t>(steps + 1e-9);
  const double part = std::max(0.0, steps - static_cast<double>(whole));
  return (1 - part) * line[whole] + part * line[whole + 1];
}

void MujocoMotor::observe(double rotor) { push(readings_, rotor + joint_.turned); }

MujocoMotor::Torques MujocoMotor::step(double speed, double link) {
  push(orders_, ordered_);
  const double arrived = late(orders_, joint_.order_delay / h_);
  if (joint_.order_filter > 0) {
    followed_ += (1 - std::exp(-h_ / joint_.order_filter)) * (arrived - followed_);
  } else {
    followed_ = arrived;
  }
  const double asked = joint_.kp * (followed_ - readings_.front()) - joint_.kd * speed;
  const double part = 1 - std::copysign(speed, asked * speed) / joint_.top_speed;
  const double most = joint_.strength * std::clamp(part, 0.0, 1.0);
  noise_ = keep_ * noise_ + fresh_ * random_.normal();
  return {std::clamp(asked, -most, most), noise_ + joint_.bias - joint_.spring * link};
}

double MujocoMotor::report() const {
  const double angle = late(readings_, joint_.report_delay / h_);
  return joint_.quantum > 0 ? joint_.quantum * std::round(angle / joint_.quantum) : angle;
}

}  // namespace nao::hidden
