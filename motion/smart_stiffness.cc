#include "motion/smart_stiffness.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/posture_family.h"

namespace nao::motion {
namespace {

// Free choices. Above the friction of a gear a motor at a fifth still moves a limb; twice the
// statics leave room for what the nominal model does not know.
constexpr double kLeast = 0.2;
constexpr double kMargin = 2;
constexpr double kSettle = 1.0;       // [s] without motion
constexpr double kEase = 0.3;         // [s] time constant of the change
constexpr double kAfterYielding = 5;  // [s] in which nothing is spared
constexpr double kYield = 0.03;       // [rad] a joint that falls back this far gives way
constexpr double kTurning = 0.3;      // [rad/s] far above the inertial unit's noise
constexpr double kGravity = 9.81;     // [m/s^2]

}  // namespace

SmartStiffness::SmartStiffness(std::shared_ptr<const RobotModel> model)
    : model_(std::move(model)), kinematics_(model_), value_(model_->jointCount()) {}

void SmartStiffness::update(double dt, const SensorFrame& measured,
                            const JointArray<double>& command, const JointArray<double>& asked) {
  const bool still = enabled_ && model_->feet.size() == 2 && model_->bodies.size() > 1 &&
                     holdsStill(measured, command, asked);
  still_ = still ? still_ + dt : std::min(still_, 0.0);
  const bool spares = still_ >= kSettle;
  if (spares && givesWay(measured, command)) still_ = -kAfterYielding;
  if (still_ >= kSettle) {
    const JointArray<double> need = calcNeed(measured);
    for (std::size_t i = 0; i < need.size(); ++i) {
      const double wanted = std::min(asked[i], need[i]);
      value_[i] = std::min(asked[i], value_[i] + std::min(1.0, dt / kEase) * (wanted - value_[i]));
    }
  } else {
    value_ = asked;
    lag_ = command;
    for (std::size_t i = 0; i < lag_.size(); ++i) lag_[i] -= measured.angle[i];
  }
  command_ = command;
  asked_ = asked;
}

bool SmartStiffness::holdsStill(const SensorFrame& measured, const JointArray<double>& command,
                                const JointArray<double>& asked) const {
  const auto same = [](const JointArray<double>& a, const JointArray<double>& b) {
    return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
  };
  if (!same(command, command_) || !same(asked, asked_)) return false;
  return measured.gyroscope.norm() < kTurning;
}

bool SmartStiffness::givesWay(const SensorFrame& measured,
                              const JointArray<double>& command) const {
  for (std::size_t i = 0; i < command.size(); ++i) {
    if (std::abs(command[i] - measured.angle[i]) > std::abs(lag_[i]) + kYield) return true;
  }
  return false;
}

JointArray<double> SmartStiffness::calcNeed(const SensorFrame& measured) {
  JointArray<double> need = calcTorques(measured);
  for (std::size_t i = 0; i < need.size(); ++i) {
    const Actuator& actuator = model_->actuators[i];
    const double most = actuator.efficiency * actuator.stall_torque;
    const bool is_known = !actuator.coordinates.empty() && most > 0;
    need[i] = is_known ? std::clamp(kMargin * need[i] / most, kLeast, 1.0) : 1.0;
  }
  return need;
}

// Weight and ground forces of all that a hinge bears, summed from the limbs' ends inwards.
JointArray<double> SmartStiffness::calcTorques(const SensorFrame& measured) {
  kinematics_.update(measured.angle);
  const Vec3 up = upInTorso(measured);
  const std::size_t count = model_->bodies.size();
  std::vector<double> lift(count);                // [N] along up
  std::vector<Vec3> moment(count, Vec3::Zero());  // [N m] about T of that
  double weight = 0;                              // [N]
  const auto bear = [&](std::size_t body, const Vec3& p_T, double force) {
    lift[body] += force;
    moment[body] += p_T.cross(force * up);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const Body& body = model_->bodies[i];
    weight += kGravity * body.mass;
    bear(i, kinematics_.getPose(static_cast<int>(i)) * body.p_BoBcm, -kGravity * body.mass);
  }
  const double felt = measured.feet[0].total + measured.feet[1].total;
  for (std::size_t f = 0; f < 2 && felt > weight / 4; ++f) {
    const FootForces& foot = measured.feet[f];
    const int body = model_->feet[f].body;
    const Vec3 p_T = kinematics_.getPose(body) * Vec3(foot.cop_x, foot.cop_y, 0);
    bear(static_cast<std::size_t>(body), p_T, foot.total * weight / felt);
  }
  JointArray<double> torque(model_->jointCount());
  for (std::size_t i = count - 1; i > 0; --i) {
    const Pose& X_TB = kinematics_.getPose(static_cast<int>(i));
    const Vec3 about = moment[i] - X_TB.translation().cross(lift[i] * up);
    torque[model_->coordinates[i - 1].joint] +=
        std::abs(about.dot(X_TB.linear() * model_->bodies[i].axis));
    const auto parent = static_cast<std::size_t>(model_->bodies[i].parent);
    lift[parent] += lift[i];
    moment[parent] += moment[i];
  }
  return torque;
}

void SmartStiffness::archive(Archive& archive) {
  archive.value(enabled_);
  archive.value(still_);
  archive.value(value_);
  archive.value(asked_);
  archive.value(command_);
  archive.value(lag_);
}

}  // namespace nao::motion
