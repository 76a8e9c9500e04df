// This robot falls as if gravity were `scale` times the world's (the thesis' simulator fell at 91
// %).
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType gravityScale() {
  return {"gravity_scale",
          "Gravity is stronger or weaker than the world says.",
          {{"scale", "", 1.05, 1, 0, 10, 0.01}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan(
                [scale = setup.value("scale")](BodyPlan& plan) { plan.gravity *= scale; });
          }};
}

}  // namespace nao::sim
