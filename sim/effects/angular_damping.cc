// Every body's turning is slowed: w' = -rate w. Nothing real: what physics engines do.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType angularDamping() {
  return {"angular_damping",
          "Everything that turns is slowed in proportion to its rate.",
          {{"rate", "1/s", 0.1, 0, 0, 100, 0.01}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan(
                [rate = setup.value("rate")](BodyPlan& plan) { plan.angular_damping += rate; });
          }};
}

}  // namespace nao::sim
