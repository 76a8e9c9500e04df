// The rotor's inertia, seen through the gear, is not the nominal one: J (1 + part).
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType motorInertia() {
  return {
      "motor_inertia",
      "The rotor is heavier or lighter than the model says.",
      {{"part", "", 0.5, 0, -0.95, 20, 0.1}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([joints = setup.hinged(), part = setup.value("part")](BodyPlan& plan) {
          for (const std::size_t j : joints) plan.model.actuators[j].rotor_inertia *= 1 + part;
        });
      }};
}

}  // namespace nao::sim
