// Dry friction in one direction only: budget of |torque| against motion towards larger angles if
// torque > 0, towards smaller angles if < 0. Source: uneven wear of gear and brushes; free choice
// of form, so that it adds to every other friction.
#include <algorithm>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class FrictionAsymmetry final : public Effect {
 public:
  explicit FrictionAsymmetry(const EffectSetup& setup)
      : joints_(setup.hinged()), torque_(setup.value("torque")) {}

  void alterDrive(const DriveMoment&, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      terms.resist_forward[j] += std::max(torque_, 0.0);
      terms.resist_backward[j] += std::max(-torque_, 0.0);
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double torque_;  // [N m]
};

}  // namespace

EffectType frictionAsymmetry() {
  return {"friction_asymmetry",
          "Dry friction against one direction of motion only.",
          {{"torque", "N m", 0.05, 0, -10, 10, 0.005}},
          Acts::OnDrive,
          makeEffect<FrictionAsymmetry>};
}

}  // namespace nao::sim
