// Dry friction that grows with what the gear carries: budget = share |T_load|, T_load of the step
// before. Source: tooth friction is Coulomb friction under the teeth's normal force.
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class LoadFriction final : public Effect {
 public:
  explicit LoadFriction(const EffectSetup& setup)
      : joints_(setup.hinged()), share_(setup.value("share")) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      const double budget = share_ * std::abs(moment.load_torque[j]);
      terms.resist_forward[j] += budget;
      terms.resist_backward[j] += budget;
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double share_;
};

}  // namespace

EffectType loadFriction() {
  return {"load_friction",
          "Dry friction in proportion to the torque that the gear carries.",
          {{"share", "", 0.1, 0, 0, 0.9, 0.01}},
          Acts::OnDrive,
          makeEffect<LoadFriction>};
}

}  // namespace nao::sim
