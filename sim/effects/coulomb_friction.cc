// Dry friction of motor and gear: |T_friction| <= torque, against the motion, or what holds still.
// With `creep` it does not stick: |T| = torque min(1, |q'| / creep), so that a load turns the joint
// slowly. Source: Coulomb's law; the step's solve sticks within the budget (sim/geared_motor.h).
#include "sim/effects/creep.h"
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class CoulombFriction final : public Effect {
 public:
  explicit CoulombFriction(const EffectSetup& setup)
      : joints_(setup.hinged()), torque_(setup.value("torque")), creep_(setup.value("creep")) {}

  void alterDrive(const DriveMoment&, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      if (creep_ > 0) {
        addCreep(torque_, torque_, creep_, j, terms);
      } else {
        terms.resist_forward[j] += torque_;
        terms.resist_backward[j] += torque_;
      }
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double torque_;  // [N m]
  double creep_;   // [rad/s]
};

}  // namespace

EffectType coulombFriction() {
  return {"coulomb_friction",
          "Dry friction of the same size at every speed; the joint sticks below it.",
          {{"torque", "N m", 0.05, 0, 0, 10, 0.005}, {"creep", "rad/s", 0, 0, 0, 1, 0.001}},
          Acts::OnDrive,
          makeEffect<CoulombFriction>};
}

}  // namespace nao::sim
