#include "sim/joint_stops.h"

#include <algorithm>

namespace nao::sim {
namespace {

constexpr double kStiffness = 2e4;  // [N m/rad] free choice: 8.4 N m / 2e4 = 0.024 degrees
constexpr double kDamping = 28;     // [N m s/rad] critical for a rotor inertia of 0.01 kg m^2

constexpr double kNear = 0.05;  // [rad] within one step a joint gets no farther than this
constexpr int kChanges = 2;     // of mind, so that a step always ends

constexpr double change(double h) { return kStiffness * h + kDamping; }

}  // namespace

JointStops::JointStops(const RobotModel& model, int root_speeds)
    : model_(model), root_speeds_(root_speeds) {
  touches_.reserve(2 * model.coordinates.size());
}

void JointStops::narrow(const CoupledLimit& limit, const double* q) {
  const int driver = model_.actuators[index(limit.driver)].coordinates.front();
  const int limited = model_.actuators[index(limit.limited)].coordinates.front();
  const auto [low, high] = limit.rangeAt(q[driver]);
  const auto i = static_cast<std::size_t>(limited);
  lower_[i] = std::max(lower_[i], low);
  upper_[i] = std::min(upper_[i], high);
}

void JointStops::prepare(const double* q, const double* u, double h) {
  h_ = h;
  lower_.clear();
  upper_.clear();
  touches_.clear();
  for (const Coordinate& coordinate : model_.coordinates) {
    lower_.push_back(coordinate.lower);
    upper_.push_back(coordinate.upper);
  }
  for (const CoupledLimit& limit : model_.coupled_limits) {
    if (limit.stop) narrow(limit, q);
  }
  for (std::size_t i = 0; i < lower_.size(); ++i) {
    const double next = q[i] + h * u[i];
    if (next > upper_[i] - kNear) approach(i, -1, upper_[i] - next, u[i]);
    if (next < lower_[i] + kNear) approach(i, 1, lower_[i] - next, u[i]);
  }
}

void JointStops::approach(std::size_t coordinate, double side, double room, double u) {
  const int speed = root_speeds_ + static_cast<int>(coordinate);
  touches_.push_back({speed, side, room, kStiffness * room - kDamping * u, side * room > 0, 0});
}

void JointStops::addTo(TreeMatrix& matrix, Eigen::VectorXd& rhs) const {
  for (const Touch& touch : touches_) {
    if (!touch.active) continue;
    rhs[touch.speed] += h_ * touch.now;
    matrix.at(touch.speed, touch.speed) += h_ * change(h_);
  }
}

void JointStops::addSmooth(const double* q, const double* u, Eigen::VectorXd& torque) {
  prepare(q, u, 0);
  for (const Touch& touch : touches_) {
    if (touch.active && touch.side * touch.now > 0) torque[touch.speed] += touch.now;
  }
}

bool JointStops::revise(const Eigen::VectorXd& du) {
  bool changed = false;
  for (Touch& touch : touches_) {
    const double torque = touch.now - change(h_) * du[touch.speed];
    const bool reached = touch.active || touch.side * (touch.room - h_ * du[touch.speed]) > 0;
    const bool pushes = reached && touch.side * torque >= 0;
    if (pushes == touch.active || touch.changes >= kChanges) continue;
    touch.active = pushes;
    ++touch.changes;
    changed = true;
  }
  return changed;
}

}  // namespace nao::sim
