// A motor that works gets warm and weak: warmth w' = ((T / T_stall)^2 - w) / time, T_stall the most
// it gives at rest, and torque limit (1 - part w) of the nominal one; w = 1 is stalled for good.
// Source: Joule heat i^2 R into one thermal mass; magnet and winding lose torque as they warm.
#include <algorithm>
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class ThermalDerating final : public Effect {
 public:
  explicit ThermalDerating(const EffectSetup& setup)
      : joints_(setup.hinged()),
        part_(setup.value("part")),
        time_(setup.value("time")),
        decay_(std::exp(-toSeconds(setup.step) / time_)),
        warmth_(joints_.size()) {
    for (const std::size_t j : joints_) {
      const Actuator& motor = setup.model.actuators[j];
      most_.push_back(std::max(motor.efficiency * motor.stall_torque, 1e-9));
    }
  }

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const std::size_t j = joints_[i];
      const double effort = moment.motor_torque[j] / most_[i];
      const double heat = effort * effort;
      warmth_[i] = heat + decay_ * (warmth_[i] - heat);
      terms.torque_part[j] *= std::max(0.0, 1 - part_ * warmth_[i]);
    }
  }

  void archive(Archive& archive) override { archive.list(warmth_); }

 private:
  std::vector<std::size_t> joints_;
  double part_;
  double time_;                 // [s]
  double decay_;                // of warmth over a step
  std::vector<double> most_;    // [N m]
  std::vector<double> warmth_;  // 0 cold, 1 stalled for good
};

}  // namespace

EffectType thermalDerating() {
  return {"thermal_derating",
          "Motors lose torque as they warm up under load.",
          {{"part", "", 0.3, 0, 0, 1, 0.02}, {"time", "s", 60, 60, 0.1, 3600, 1}},
          Acts::OnDrive,
          makeEffect<ThermalDerating>};
}

}  // namespace nao::sim
