#include "validation/diagnosis/rig/led_joint.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"
#include "sim/effects/effect.h"
#include "validation/diagnosis/maths/lag.h"
#include "validation/diagnosis/maths/moving_mean.h"

namespace nao::validation {
namespace {

constexpr Eigen::Index kSmooth = 1;  // samples to each side, twice: derivatives of noise are noise
// [rad/s] Of the spring on the inertia. It leaves the servo up to a third of a torque, the same
// part of all; a stiffer one follows the noise of readings, under which signatures are lost.
constexpr double kPace = 250;

Eigen::VectorXd smooth(const Eigen::VectorXd& x) {
  return movingMean(movingMean(x, kSmooth), kSmooth);
}

Eigen::VectorXd slope(const Eigen::VectorXd& x, double dt) {
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(x.size());
  for (Eigen::Index i = 1; i + 1 < x.size(); ++i) rate[i] = (x[i + 1] - x[i - 1]) / (2 * dt);
  return rate;
}

}  // namespace

Eigen::MatrixXd withRates(const Eigen::VectorXd& angle, double dt) {
  Eigen::MatrixXd all(angle.size(), 3);
  all.col(0) = smooth(angle);
  all.col(1) = slope(all.col(0), dt);
  all.col(2) = slope(all.col(1), dt);
  return all;
}

class LedJoint::Watch final : public sim::Effect {
 public:
  explicit Watch(LedJoint& led) : led_(led) {}

  void alterDrive(const sim::DriveMoment& moment, sim::DriveTerms&) override {
    led_.own_.emplace_back(moment.angle[0], moment.rate[0]);
    const double place = (toSeconds(moment.time) - led_.settle_) / led_.row_;
    const auto row = static_cast<Eigen::Index>(std::ceil(place));
    if (row >= 0 && row < led_.sum_.angle.size()) led_.sum_.angle[row] = moment.angle[0];
  }

 private:
  LedJoint& led_;
};

class LedJoint::Lead final : public sim::Effect {
 public:
  explicit Lead(LedJoint& led) : led_(led) {}

  void alterCommand(JointCommand& command, SimTime now, double) override {
    command.angle[0] -= atRow(led_.misread_, (toSeconds(now) - led_.settle_) / led_.row_);
  }

  void alterDrive(const sim::DriveMoment& moment, sim::DriveTerms& terms) override {
    NAO_CHECK(step_ < led_.own_.size());
    const auto [angle, rate] = led_.own_[step_++];
    const double then = step_ < led_.own_.size() ? led_.own_[step_].second : rate;
    const double place = (toSeconds(moment.time) - led_.settle_) / led_.row_;
    const double drag = led_.damping_ * (rate + atRow(led_.rate_off_, place) - moment.rate[0]);
    const double pull = led_.stiffness_ * (angle + atRow(led_.off_, place) - moment.angle[0]);
    // The damper acts by the rate that the step ends with.
    terms.disturbance[0] += pull + drag + led_.damping_ * (moment.rate[0] + then - rate);
    terms.viscous[0] += led_.damping_;
    const auto row = static_cast<Eigen::Index>(std::floor(place));
    if (row < 0 || row >= led_.steps_.size()) return;
    led_.sum_.torque[row] += pull + drag;
    const double error = moment.command[0] - moment.angle[0];
    if (!led_.isAtItsLimit(error, moment.rate[0])) led_.sum_.error[row] += error;
    led_.steps_[row] += 1;
  }

 private:
  LedJoint& led_;
  std::size_t step_ = 0;
};

LedJoint::LedJoint(const Eigen::VectorXd& off, const Eigen::VectorXd& misread, double row,
                   double settle, double inertia, const Actuator& motor)
    : row_(row),
      settle_(settle),
      motor_(motor),
      stiffness_(inertia * kPace * kPace),
      damping_(2 * inertia * kPace),
      sum_{Eigen::VectorXd::Zero(off.size()), Eigen::VectorXd::Zero(off.size()),
           Eigen::VectorXd::Zero(off.size())},
      steps_(Eigen::VectorXd::Zero(off.size())) {
  const Eigen::MatrixXd beside = withRates(off, row);
  off_ = beside.col(0);
  rate_off_ = beside.col(1);
  misread_ = smooth(misread);
}

// Of the motor, which gives less the faster it turns.
bool LedJoint::isAtItsLimit(double error, double rate) const {
  const double torque = motor_.kp * error - motor_.kd * rate;
  const double ratio = std::copysign(1, torque) * rate / motor_.no_load_speed;
  const double most = motor_.efficiency * motor_.stall_torque;
  return std::abs(torque) > most * std::clamp(1 - ratio, 0.0, 1.0);
}

sim::EffectCatalogue LedJoint::watch(sim::EffectCatalogue catalogue) {
  catalogue.add({kName,
                 "The joint's course is taken down.",
                 {},
                 sim::Acts::OnDrive,
                 [this](const sim::EffectSetup&) { return std::make_unique<Watch>(*this); }});
  return catalogue;
}

sim::EffectCatalogue LedJoint::lead(sim::EffectCatalogue catalogue) {
  catalogue.add({kName,
                 "The joint is led beside its own course.",
                 {},
                 sim::Acts::OnCommand | sim::Acts::OnDrive,
                 [this](const sim::EffectSetup&) { return std::make_unique<Lead>(*this); }});
  return catalogue;
}

LedRun LedJoint::found() const {
  const Eigen::VectorXd steps = steps_.cwiseMax(1);
  return {sum_.torque.cwiseQuotient(steps), sum_.error.cwiseQuotient(steps), sum_.angle};
}

}  // namespace nao::validation
