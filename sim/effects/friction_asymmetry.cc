// Dry friction in one direction only: budget of |torque| against motion towards larger angles if
// torque > 0, towards smaller angles if < 0. With `creep` it does not stick: |T| = |torque|
// min(1, |q'| / creep), so that a load turns the joint slowly. Source: uneven wear of gear and
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

  void alterDrive(const DriveMoment&, DriveTerms& terms) override {
    const double forward = std::max(torque_, 0.0), backward = std::max(-torque_, 0.0);
    for (const std::size_t j : joints_) {
      if (creep_ > 0) {
        addCreep(forward, backward, creep_, j, terms);
      } else {
        terms.resist_forward[j] += forward;
        terms.resist_backward[j] += backward;
      }
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
