// Dry friction in one direction only: budget of |torque| against motion towards larger angles if
// torque > 0, towards smaller angles if < 0. With `creep` it does not stick: |T| = torque
// tanh(|q'| / creep), so that a load turns the joint slowly. Source: uneven wear of gear and
// brushes; free choice of form, so that it adds to every other friction.
#include <algorithm>

#include "sim/effects/creep.h"
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class FrictionAsymmetry final : public Effect {
 public:
  explicit FrictionAsymmetry(const EffectSetup& setup)
      : joints_(setup.hinged()), torque_(setup.value("torque")), creep_(setup.value("creep")) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      if (creep_ > 0) {
        if (moment.rate[j] * torque_ >= 0) {
          terms.viscous[j] += creepDamping(torque_, creep_, moment.rate[j]);
        }
        continue;
      }
      terms.resist_forward[j] += std::max(torque_, 0.0);
      terms.resist_backward[j] += std::max(-torque_, 0.0);
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double torque_;  // [N m]
  double creep_;   // [rad/s]
};

}  // namespace

EffectType frictionAsymmetry() {
  return {"friction_asymmetry",
          "Dry friction against one direction of motion only.",
          {{"torque", "N m", 0.05, 0, -10, 10, 0.005}, {"creep", "rad/s", 0, 0, 0, 1, 0.001}},
          Acts::OnDrive,
          makeEffect<FrictionAsymmetry>};
}

}  // namespace nao::sim
