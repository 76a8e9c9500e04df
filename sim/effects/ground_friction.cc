// The ground holds this robot better or worse: mu = scale * the world's.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType groundFriction() {
  return {"ground_friction",
          "The ground is more or less slippery than the world says.",
          {{"scale", "", 0.6, 1, 0, 10, 0.05}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan(
                [scale = setup.value("scale")](BodyPlan& plan) { plan.ground.friction *= scale; });
          }};
}

}  // namespace nao::sim
