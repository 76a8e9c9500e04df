// Links are heavier or lighter than the model: mass (1 + part), inertia about the centre of mass,
// which stays, (1 + inertia part): 1 for a link that is denser all over, 0 for a weight at its
// centre of mass. Which: the bodies that hang directly on the named joints; all but the root if
// none is named.
#include <algorithm>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

constexpr double kLeast = 0.01;  // of an inertia: none may vanish

}  // namespace

EffectType linkMass() {
  return {"link_mass",
          "The bodies directly on these joints are heavier or lighter than the model says.",
          {{"part", "", 0.1, 0, -0.95, 100, 0.05}, {"inertia", "", 1, 1, 0, 2, 0.5}},
          Acts::Once,
          [](const EffectSetup& setup) {
            const double part = setup.value("part"), inertia = setup.value("inertia");
            return changePlan([bodies = setup.bodies(), part, inertia](BodyPlan& plan) {
              for (const std::size_t b : bodies) {
                plan.model.bodies[b].mass *= 1 + part;
                plan.model.bodies[b].I_Bcm *= std::max(kLeast, 1 + inertia * part);
              }
            });
          }};
}

}  // namespace nao::sim
