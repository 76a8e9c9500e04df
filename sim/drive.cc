#include "sim/drive.h"

#include <algorithm>
#include <cmath>

namespace nao::sim {
namespace {

// What gear and magnets of a motor without current hold, as a part of its stall torque. Estimate:
// a Nao switched off in Crouch stays there, which takes 3 %.
constexpr double kHold = 0.05;
// [N m s/rad] The creep of a held joint: 0.4 N m would turn it by 1 degree in 12 hours.
constexpr double kRest = 1e6;

}  // namespace

Drive::Drive(const RobotModel& model, int root_speeds)
    : model_(model),
      root_speeds_(root_speeds),
      rotor_inertia_(
          Eigen::VectorXd::Zero(root_speeds + static_cast<int>(model.coordinates.size()))),
      motors_(model.jointCount()),
      torque_(model.jointCount()) {
  for (std::size_t j = 0; j < motors_.size(); ++j) {
    const Actuator& actuator = model.actuators[j];
    if (actuator.coordinates.empty()) continue;
    motors_[j].share = 1.0 / static_cast<double>(actuator.coordinates.size());
    for (const int c : actuator.coordinates) {
      rotor_inertia_[root_speeds + c] = motors_[j].share * actuator.rotor_inertia;
    }
  }
}

void Drive::prepare(const JointCommand& command, const double* q, const double* u, double h) {
  h_ = h;
  for (std::size_t j = 0; j < motors_.size(); ++j) {
    const std::vector<int>& coordinates = model_.actuators[j].coordinates;
    if (coordinates.empty()) continue;
    prepareMotor(j, command, q[coordinates.front()], u[coordinates.front()], h);
  }
}

void Drive::prepareMotor(std::size_t j, const JointCommand& command, double q, double u, double h) {
  const Actuator& actuator = model_.actuators[j];
  Motor& motor = motors_[j];
  motor.saturated = false;
  const double stiffness = std::min(command.stiffness[j], 1.0);
  if (stiffness <= 0) return prepareLimp(actuator, stiffness < 0, u, motor);
  motor.now = actuator.kp * (command.angle[j] - q - h * u) - actuator.kd * u;
  motor.change = actuator.kp * h + actuator.kd;
  const double limit = stiffness * actuator.efficiency * actuator.stall_torque;
  const double ratio = u / actuator.no_load_speed;
  motor.limit_up = limit * std::clamp(1 - ratio, 0.0, 1.0);
  motor.limit_down = limit * std::clamp(1 + ratio, 0.0, 1.0);
}

// The joint rests unless more than the motor's hold pulls at it; then it moves against that and,
// with the windings shorted, against the brake.
void Drive::prepareLimp(const Actuator& actuator, bool open, double u, Motor& motor) {
  const double brake = open ? 0 : actuator.stall_torque / actuator.no_load_speed;
  motor.change = kRest;
  motor.now = -kRest * u;
  motor.limit_up = motor.limit_down = kHold * actuator.stall_torque + brake * std::abs(u);
}

void Drive::addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) const {
  for (std::size_t j = 0; j < motors_.size(); ++j) {
    const Motor& motor = motors_[j];
    for (const int c : model_.actuators[j].coordinates) {
      const int speed = root_speeds_ + c;
      rhs[speed] += h_ * motor.share * motor.now;
      matrix.at(speed, speed) += h_ * motor.share * motor.change;
    }
  }
}

bool Drive::revise(const Eigen::VectorXd& du) {
  bool changed = false;
  for (std::size_t j = 0; j < motors_.size(); ++j) {
    Motor& motor = motors_[j];
    if (model_.actuators[j].coordinates.empty()) continue;
    const double rate_change = du[root_speeds_ + model_.actuators[j].coordinates.front()];
    torque_[j] = motor.now - motor.change * rate_change;
    if (motor.saturated) continue;
    if (torque_[j] <= motor.limit_up && torque_[j] >= -motor.limit_down) continue;
    motor.now = torque_[j] > 0 ? motor.limit_up : -motor.limit_down;
    motor.change = 0;
    motor.saturated = changed = true;
  }
  return changed;
}

}  // namespace nao::sim
