// The mechanical stops are not where the model says: both ends of every hinge's range, moved
// towards larger angles by `lower` and `upper`. What NaoQi clips commands to stays. Ends that would
// meet stay.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType jointStop() {
  return {"joint_stop",
          "A joint's mechanical stops lie elsewhere than the model says.",
          {{"lower", "rad", 0.05, 0, -1, 1, 0.0035}, {"upper", "rad", -0.05, 0, -1, 1, 0.0035}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan([bodies = setup.bodies(), lower = setup.value("lower"),
                               upper = setup.value("upper")](BodyPlan& plan) {
              for (const std::size_t b : bodies) {
                Coordinate& hinge = plan.model.coordinates[b - 1];
                if (hinge.lower + lower >= hinge.upper + upper) continue;
                hinge.lower += lower;
                hinge.upper += upper;
              }
            });
          }};
}

}  // namespace nao::sim
