#include "sim/drive.h"

namespace nao::sim {

Drive::Drive(const BodyPlan& plan, int root_speeds)
    : root_speeds_(root_speeds),
      rotor_inertia_(
          Eigen::VectorXd::Zero(root_speeds + static_cast<int>(plan.model.coordinates.size()))),
      angle_(plan.model.jointCount()),
      rate_(plan.model.jointCount()),
      torque_(plan.model.jointCount()),
      load_(plan.model.jointCount()) {
  for (std::size_t j = 0; j < plan.model.jointCount(); ++j) {
    const Actuator& actuator = plan.model.actuators[j];
    const std::vector<int>& hinges = actuator.coordinates;
    if (hinges.empty()) continue;
    motors_.emplace_back(plan, j);
    const double share = 1.0 / static_cast<double>(hinges.size());
    places_.push_back({j, hinges[0], {}, share, actuator.board});
    for (const int c : hinges) places_.back().speeds.push_back(root_speeds + c);
    if (motors_.back().soft()) continue;
    for (const int c : hinges) rotor_inertia_[root_speeds + c] = share * actuator.rotor_inertia;
  }
}

void Drive::reset(const double* q) {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    motors_[i].reset(q[places_[i].coordinate]);
    const std::size_t j = places_[i].joint;
    angle_[j] = motors_[i].angle();
    rate_[j] = torque_[j] = load_[j] = 0;
  }
}

void Drive::observe(const double* q, const double* u) {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    const Place& place = places_[i];
    motors_[i].observe(q[place.coordinate], u[place.coordinate]);
    angle_[place.joint] = motors_[i].angle();
    rate_[place.joint] = motors_[i].rate();
  }
}

void Drive::prepare(const JointCommand& command, const double* q, const double* u, double h,
                    const DriveTerms* terms) {
  h_ = h;
  GearedMotor::Input input;
  input.h = h;
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    const Place& place = places_[i];
    const std::size_t j = place.joint;
    input.q = q[place.coordinate];
    input.u = u[place.coordinate];
    input.command = command.angle[j];
    input.stiffness = command.stiffness[j];
    input.open = input.stiffness < 0 && boardIsOff(command, place);
    if (terms) input.take(*terms, j);
    motors_[i].prepare(input);
  }
}

bool Drive::boardIsOff(const JointCommand& command, const Place& place) const {
  if (place.board < 0) return true;
  for (const Place& other : places_) {
    if (other.board == place.board && command.stiffness[other.joint] >= 0) return false;
  }
  return true;
}

void Drive::addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) const {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    const Place& place = places_[i];
    const double push = h_ * place.share * motors_[i].now();
    const double fall = h_ * place.share * motors_[i].change();
    for (const int speed : place.speeds) {
      rhs[speed] += push;
      matrix.at(speed, speed) += fall;
    }
  }
}

void Drive::addSmooth(const JointCommand& command, const double* q, const double* u,
                      Eigen::VectorXd& torque) {
  prepare(command, q, u, 0, nullptr);
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    const Place& place = places_[i];
    const double push = motors_[i].smoothTorque();
    torque_[place.joint] = load_[place.joint] = push;
    for (const int speed : place.speeds) torque[speed] += place.share * push;
  }
}

bool Drive::revise(const Eigen::VectorXd& du) {
  bool changed = false;
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    changed |= motors_[i].revise(du[places_[i].speeds.front()]);
  }
  return changed;
}

void Drive::finish(const Eigen::VectorXd& du) {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    motors_[i].finish(du[places_[i].speeds.front()]);
    torque_[places_[i].joint] = motors_[i].torque();
    load_[places_[i].joint] = motors_[i].load();
  }
}

JointArray<bool> Drive::saturated() const {
  JointArray<bool> saturated(torque_.size());
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    saturated[places_[i].joint] = motors_[i].saturated();
  }
  return saturated;
}

void Drive::archive(Archive& archive) {
  for (std::size_t i = 0; i < motors_.size(); ++i) {
    motors_[i].archive(archive);
    const std::size_t j = places_[i].joint;
    angle_[j] = motors_[i].angle();
    rate_[j] = motors_[i].rate();
    torque_[j] = motors_[i].torque();
    load_[j] = motors_[i].load();
  }
}

}  // namespace nao::sim
