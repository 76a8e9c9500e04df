// The gear bends: deflection = compliance T, with damping across it. Two such effects on one joint
// are springs in a row. Law: sim/geared_motor.h.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType gearCompliance() {
  return {"gear_compliance",
          "The gear bends under load like a spring.",
          {{"compliance", "rad/(N m)", 0.005, 0, 0, 1, 5e-4},
           {"damping", "N m s/rad", 0.2, 0.2, 0, 100, 0.02}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan([joints = setup.hinged(), compliance = setup.value("compliance"),
                               damping = setup.value("damping")](BodyPlan& plan) {
              if (compliance <= 0) return;
              for (const std::size_t j : joints) {
                Transmission& gear = plan.transmissions[j];
                gear.stiffness = 1 / (compliance + (gear.stiffness > 0 ? 1 / gear.stiffness : 0));
                gear.damping = damping;
              }
            });
          }};
}

}  // namespace nao::sim
