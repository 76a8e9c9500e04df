// Dry friction that grows with what the gear carries, by another share when the motor drives the
// load than when the load drives the motor: budget against a motion = motoring |T_load| if that
// motion is along T_load, braking |T_load| if it is against, T_load of the step before. Source: a
// tooth slides towards the pitch point on one side of the mesh, away from it on the other, so that
// a gear wears and loses unevenly; the split is that of published servo models (Rhoban's BAM, M4
// on).
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class DirectionalLoadFriction final : public Effect {
 public:
  explicit DirectionalLoadFriction(const EffectSetup& setup)
      : joints_(setup.hinged()),
        motoring_(setup.value("motoring")),
        braking_(setup.value("braking")) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      const double load = moment.load_torque[j];
      terms.resist_forward[j] += (load > 0 ? motoring_ : braking_) * std::abs(load);
      terms.resist_backward[j] += (load > 0 ? braking_ : motoring_) * std::abs(load);
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double motoring_, braking_;
};

}  // namespace

EffectType directionalLoadFriction() {
  return {"directional_load_friction",
          "Dry friction in proportion to the gear's torque, unequal when driving and when driven.",
          {{"motoring", "", 0.1, 0, 0, 0.9, 0.01}, {"braking", "", 0, 0, 0, 0.9, 0.01}},
          Acts::OnDrive,
          makeEffect<DirectionalLoadFriction>};
}

}  // namespace nao::sim
