// The battery is low: V / V_nominal = 1 - drop - slope t. Stall torque and no-load speed of a motor
// are proportional to V, so torque = part stall - stall |q'| / no_load: little changes at rest.
// Source: the linear torque-speed line of a DC motor.
#include <algorithm>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class VoltageSag final : public Effect {
 public:
  explicit VoltageSag(const EffectSetup& setup)
      : joints_(setup.hinged()), drop_(setup.value("drop")), slope_(setup.value("slope")) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    const double part = std::max(0.0, 1 - drop_ - slope_ * time_);
    time_ += moment.h;
    for (const std::size_t j : joints_) {
      terms.torque_part[j] *= part;
      terms.speed_part[j] *= part;
    }
  }

  void archive(Archive& archive) override { archive.value(time_); }

 private:
  std::vector<std::size_t> joints_;
  double drop_;
  double slope_;     // [1/s]
  double time_ = 0;  // [s] since the run began
};

}  // namespace

EffectType voltageSag() {
  return {"voltage_sag",
          "A low battery takes torque and, more so, speed; it may sink as the run goes on.",
          {{"drop", "", 0.15, 0, -0.5, 0.9, 0.02}, {"slope", "1/s", 0, 0, -0.1, 0.1, 1e-4}},
          Acts::OnDrive,
          makeEffect<VoltageSag>};
}

}  // namespace nao::sim
