// Links are heavier or lighter than the model: mass and inertia (1 + part), the centre of mass
// stays. Which: the bodies that hang directly on the named joints; all but the root if none is
// named.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType linkMass() {
  return {
      "link_mass",
      "The bodies directly on these joints are heavier or lighter than the model says.",
      {{"part", "", 0.1, 0, -0.95, 10, 0.05}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([bodies = setup.bodies(), part = setup.value("part")](BodyPlan& plan) {
          for (const std::size_t b : bodies) {
            plan.model.bodies[b].mass *= 1 + part;
            plan.model.bodies[b].I_Bcm *= 1 + part;
          }
        });
      }};
}

}  // namespace nao::sim
