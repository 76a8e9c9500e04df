// Dry friction of motor and gear: |T_friction| <= torque, against the motion, or what holds still.
// Source: Coulomb's law; the step's solve sticks within the budget (sim/geared_motor.h).
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class CoulombFriction final : public Effect {
 public:
  explicit CoulombFriction(const EffectSetup& setup)
      : joints_(setup.hinged()), torque_(setup.value("torque")) {}

  void alterDrive(const DriveMoment&, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      terms.resist_forward[j] += torque_;
      terms.resist_backward[j] += torque_;
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double torque_;  // [N m]
};

}  // namespace

EffectType coulombFriction() {
  return {"coulomb_friction",
          "Dry friction of the same size at every speed; the joint sticks below it.",
          {{"torque", "N m", 0.05, 0, 0, 10, 0.005}},
          Acts::OnDrive,
          makeEffect<CoulombFriction>};
}

}  // namespace nao::sim
