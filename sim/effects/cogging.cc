// The motor's magnets prefer some angles: T = torque sin(per_turn q + phase), per_turn periods in
// 2 pi of the joint; a negative torque is half a period further. Source: reluctance torque of a
// slotted motor, seen through the gear.
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class Cogging final : public Effect {
 public:
  explicit Cogging(const EffectSetup& setup)
      : joints_(setup.hinged()),
        torque_(setup.value("torque")),
        per_turn_(setup.value("per_turn")),
        phase_(setup.value("phase")) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      terms.disturbance[j] += torque_ * std::sin(per_turn_ * moment.angle[j] + phase_);
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double torque_;    // [N m]
  double per_turn_;  // [1/rad]
  double phase_;     // [rad]
};

}  // namespace

EffectType cogging() {
  return {"cogging",
          "The joint's torque ripples with its angle.",
          {{"torque", "N m", 0.05, 0, -5, 5, 0.01},
           {"per_turn", "", 12, 12, 4, 200, 0.5},
           {"phase", "rad", 0, 0, -7, 7, 0.2}},
          Acts::OnDrive,
          makeEffect<Cogging>};
}

}  // namespace nao::sim
