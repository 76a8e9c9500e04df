// The servo's proportional gain is not the nominal one: kp (1 + part).
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType kpError() {
  return {
      "kp_error",
      "The servo is stiffer or softer than the model says.",
      {{"part", "", 0.2, 0, -0.95, 10, 0.05}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([joints = setup.hinged(), part = setup.value("part")](BodyPlan& plan) {
          for (const std::size_t j : joints) plan.model.actuators[j].kp *= 1 + part;
        });
      }};
}

}  // namespace nao::sim
