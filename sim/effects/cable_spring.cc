// A cable, a skin or a rubber cover pulls the joint back: T = -stiffness (q - rest). Linear, as for
// small bends of a bundle of wires; explicit in the step, so meant for springs far softer than the
// servo.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class CableSpring final : public Effect {
 public:
  explicit CableSpring(const EffectSetup& setup)
      : joints_(setup.hinged()), stiffness_(setup.value("stiffness")), rest_(setup.value("rest")) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      terms.disturbance[j] -= stiffness_ * (moment.angle[j] - rest_);
    }
  }

 private:
  std::vector<std::size_t> joints_;
  double stiffness_;  // [N m/rad]
  double rest_;       // [rad]
};

}  // namespace

EffectType cableSpring() {
  return {"cable_spring",
          "A cable or a skin pulls the joint back to where it rests.",
          {{"stiffness", "N m/rad", 0.3, 0, -5, 20, 0.03}, {"rest", "rad", 0, 0, -3.2, 3.2, 0.05}},
          Acts::OnDrive,
          makeEffect<CableSpring>};
}

}  // namespace nao::sim
