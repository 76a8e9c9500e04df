// The servo integrates its error: T = gain * integral of (command - q) dt, at most half of what the
// motor gives at rest (anti-windup, a free choice), forgotten while the joint is without stiffness.
#include <algorithm>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class IntegralGain final : public Effect {
 public:
  explicit IntegralGain(const EffectSetup& setup)
      : joints_(setup.hinged()), gain_(setup.value("gain")), torque_(joints_.size()) {
    for (const std::size_t j : joints_) {
      const Actuator& motor = setup.model.actuators[j];
      most_.push_back(motor.efficiency * motor.stall_torque / 2);
    }
  }

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const std::size_t j = joints_[i];
      torque_[i] += gain_ * (moment.command[j] - moment.angle[j]) * moment.h;
      torque_[i] = moment.stiffness[j] > 0 ? std::clamp(torque_[i], -most_[i], most_[i]) : 0;
      terms.disturbance[j] += torque_[i];
    }
  }

  void archive(Archive& archive) override { archive.list(torque_); }

 private:
  std::vector<std::size_t> joints_;
  double gain_;                        // [N m/(rad s)]
  std::vector<double> torque_, most_;  // [N m]
};

}  // namespace

EffectType integralGain() {
  return {"integral_gain",
          "The servo integrates its error until it is gone.",
          {{"gain", "N m/(rad s)", 20, 0, 0, 500, 2}},
          Acts::OnDrive,
          makeEffect<IntegralGain>};
}

}  // namespace nao::sim
