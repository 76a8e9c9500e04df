// Extra dry friction near standstill: budget = torque exp(-|q' / speed|^exponent).
// Source: Stribeck curve; the exponent is 2 in its Gaussian form, 0.5 to 1 in measured bearings
// (Armstrong-Helouvry, Dupont, Canudas de Wit 1994).
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class StribeckFriction final : public Effect {
 public:
  explicit StribeckFriction(const EffectSetup& setup)
      : joints_(setup.hinged()),
        torque_(setup.value("torque")),
        speed_(setup.value("speed")),
        exponent_(setup.value("exponent")) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      const double part = moment.rate[j] / speed_;
      const double budget = torque_ * std::exp(-std::pow(part * part, exponent_ / 2));
      terms.resist_forward[j] += budget;
      terms.resist_backward[j] += budget;
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double torque_;  // [N m]
  double speed_;   // [rad/s]
  double exponent_;
};

}  // namespace

EffectType stribeckFriction() {
  return {"stribeck_friction",
          "Dry friction near standstill that fades as the joint moves: stick and slip.",
          {{"torque", "N m", 0.05, 0, 0, 10, 0.005},
           {"speed", "rad/s", 0.1, 0.1, 1e-3, 10, 0.01},
           {"exponent", "", 2, 2, 0.3, 2, 0.2}},
          Acts::OnDrive,
          makeEffect<StribeckFriction>};
}

}  // namespace nao::sim
