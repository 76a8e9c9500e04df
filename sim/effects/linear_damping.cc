// Every body is slowed: a = -rate v of its centre of mass. Nothing real: what physics engines do.
// Source: ODE and Karma, whose damping the thesis measured as part of its gravity error.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType linearDamping() {
  return {"linear_damping",
          "Everything that moves is slowed in proportion to its speed.",
          {{"rate", "1/s", 0.1, 0, 0, 100, 0.01}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan(
                [rate = setup.value("rate")](BodyPlan& plan) { plan.linear_damping += rate; });
          }};
}

}  // namespace nao::sim
