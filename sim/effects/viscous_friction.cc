// Friction that grows with speed: T = -coefficient q'. Source: grease in the gear; Stokes' law.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class ViscousFriction final : public Effect {
 public:
  explicit ViscousFriction(const EffectSetup& setup)
      : joints_(setup.hinged()), coefficient_(setup.value("coefficient")) {}

  void alterDrive(const DriveMoment&, DriveTerms& terms) override {
    for (const std::size_t j : joints_) terms.viscous[j] += coefficient_;
  }

 private:
  std::vector<std::size_t> joints_;
  double coefficient_;  // [N m s/rad]
};

}  // namespace

EffectType viscousFriction() {
  return {"viscous_friction",
          "Friction that grows in proportion to speed.",
          {{"coefficient", "N m s/rad", 0.05, 0, 0, 10, 0.005}},
          Acts::OnDrive,
          makeEffect<ViscousFriction>};
}

}  // namespace nao::sim
