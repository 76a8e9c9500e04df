// Dry friction that grows with what the gear carries: budget = share ((1 - of_motor) |T_load| +
// of_motor |T_motor|), of the step before. Source: tooth friction is Coulomb friction under the
// teeth's normal force, which friction itself adds to on the way from the motor to the link;
// published servo models (Rhoban's BAM) let both torques count.
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class LoadFriction final : public Effect {
 public:
  explicit LoadFriction(const EffectSetup& setup)
      : joints_(setup.hinged()),
        of_load_(setup.value("share") * (1 - setup.value("of_motor"))),
        of_motor_(setup.value("share") * setup.value("of_motor")) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      const double budget =
          of_load_ * std::abs(moment.load_torque[j]) + of_motor_ * std::abs(moment.motor_torque[j]);
      terms.resist_forward[j] += budget;
      terms.resist_backward[j] += budget;
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double of_load_, of_motor_;
};

}  // namespace

EffectType loadFriction() {
  return {"load_friction",
          "Dry friction in proportion to the torque that the gear carries.",
          {{"share", "", 0.1, 0, 0, 0.9, 0.01}, {"of_motor", "", 0, 0, 0, 1, 0.25}},
          Acts::OnDrive,
          makeEffect<LoadFriction>};
}

}  // namespace nao::sim
