// The servo's derivative gain is not the nominal one: kd (1 + part).
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType kdError() {
  return {
      "kd_error",
      "The servo is more or less damped than the model says.",
      {{"part", "", 0.2, 0, -1, 10, 0.05}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([joints = setup.hinged(), part = setup.value("part")](BodyPlan& plan) {
          for (const std::size_t j : joints) plan.model.actuators[j].kd *= 1 + part;
        });
      }};
}

}  // namespace nao::sim
