// Part of the torque at every speed is missing: limit = part * nominal limit, where the motor holds
// as where it lifts (a lesser current limit; a gear of lesser efficiency would hold more).
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType torqueLimit() {
  return {
      "torque_limit",
      "The motor gives only a part of its torque.",
      {{"part", "", 0.8, 1, 0, 3, 0.02}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([joints = setup.hinged(), part = setup.value("part")](BodyPlan& plan) {
          for (const std::size_t j : joints) plan.torque_part[j] *= part;
        });
      }};
}

}  // namespace nao::sim
