#include "validation/diagnosis/rig/led_joint.h"

#include <algorithm>
#include <cmath>

#include "sim/effects/effect.h"
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

// Linear between rows.
double at(const Eigen::VectorXd& rows, double place) {
  const double last = static_cast<double>(rows.size() - 1);
  const double inside = std::clamp(place, 0.0, last);
  const auto row = static_cast<Eigen::Index>(inside);
  const Eigen::Index next = std::min(row + 1, rows.size() - 1);
  return rows[row] + (inside - static_cast<double>(row)) * (rows[next] - rows[row]);
}

}  // namespace

Eigen::MatrixXd withRates(const Eigen::VectorXd& angle, double dt) {
  Eigen::MatrixXd all(angle.size(), 3);
  all.col(0) = smooth(angle);
  all.col(1) = slope(all.col(0), dt);
  all.col(2) = slope(all.col(1), dt);
  return all;
}

class LedJoint::Lead final : public sim::Effect {
 public:
  explicit Lead(LedJoint& led) : led_(led) {}

  void alterCommand(JointCommand& command, SimTime now, double) override {
    command.angle[0] -= at(led_.misread_, (toSeconds(now) - led_.settle_) / led_.row_);
  }

  void alterDrive(const sim::DriveMoment& moment, sim::DriveTerms& terms) override {
    const double place = (toSeconds(moment.time) - led_.settle_) / led_.row_;
    const double drag = led_.damping_ * (at(led_.rate_, place) - moment.rate[0]);
    const double pull = led_.stiffness_ * (at(led_.angle_, place) - moment.angle[0]);
    terms.disturbance[0] += pull + drag + led_.damping_ * moment.rate[0];
    terms.viscous[0] += led_.damping_;
    const auto row = static_cast<Eigen::Index>(std::floor(place));
    if (row < 0 || row >= led_.steps_.size()) return;
    led_.sum_.torque[row] += pull + drag;
    const double error = moment.command[0] - moment.angle[0];
    if (std::abs(error) < led_.reach_) led_.sum_.error[row] += error;
    led_.steps_[row] += 1;
  }

 private:
  LedJoint& led_;
};

LedJoint::LedJoint(const Eigen::VectorXd& angle, const Eigen::VectorXd& misread, double row,
                   double settle, double inertia, double reach)
    : row_(row),
      settle_(settle),
      reach_(reach),
      stiffness_(inertia * kPace * kPace),
      damping_(2 * inertia * kPace),
      sum_{Eigen::VectorXd::Zero(angle.size()), Eigen::VectorXd::Zero(angle.size())},
      steps_(Eigen::VectorXd::Zero(angle.size())) {
  const Eigen::MatrixXd course = withRates(angle, row);
  angle_ = course.col(0);
  rate_ = course.col(1);
  misread_ = smooth(misread);
}

sim::EffectCatalogue LedJoint::in(sim::EffectCatalogue catalogue) {
  catalogue.add({kName,
                 "The joint is led along a course.",
                 {},
                 sim::Acts::OnCommand | sim::Acts::OnDrive,
                 [this](const sim::EffectSetup&) { return std::make_unique<Lead>(*this); }});
  return catalogue;
}

LedRun LedJoint::found() const {
  const Eigen::VectorXd steps = steps_.cwiseMax(1);
  return {sum_.torque.cwiseQuotient(steps), sum_.error.cwiseQuotient(steps)};
}

}  // namespace nao::validation
