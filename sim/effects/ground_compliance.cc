// The ground gives way (carpet): stiffness / softness in both directions, damping * damping.
// Laws of contact: sim/ground_contact.h.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType groundCompliance() {
  return {"ground_compliance",
          "The ground is softer or harder than the world says.",
          {{"softness", "", 4, 1, 0.01, 1000, 0.2}, {"damping", "", 1, 1, 0, 100, 0.2}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan([softness = setup.value("softness"),
                               damping = setup.value("damping")](BodyPlan& plan) {
              plan.ground.stiffness /= softness;
              plan.ground.tangential_stiffness /= softness;
              plan.ground.damping *= damping;
              plan.ground.tangential_damping *= damping;
            });
          }};
}

}  // namespace nao::sim
