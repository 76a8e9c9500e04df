// The centre of mass of a link is not where the model says: moved by (x, y, z), in its own axes.
// Which: the bodies that hang directly on the named joints; all but the root if none is named.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType linkCom() {
  return {"link_com",
          "The centre of mass of the bodies directly on these joints lies elsewhere.",
          {{"x", "m", 0.005, 0, -0.5, 0.5, 0.001},
           {"y", "m", 0, 0, -0.5, 0.5, 0.001},
           {"z", "m", 0, 0, -0.5, 0.5, 0.001}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan([bodies = setup.bodies(),
                               shift = Vec3(setup.value("x"), setup.value("y"), setup.value("z"))](
                                  BodyPlan& plan) {
              for (const std::size_t b : bodies) plan.model.bodies[b].p_BoBcm += shift;
            });
          }};
}

}  // namespace nao::sim
