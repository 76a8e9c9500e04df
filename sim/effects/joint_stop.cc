// The mechanical stops are not where the model says: each moved by an angle, positive towards
// larger angles. Source: tolerances of the shells; a stop that something is stuck behind.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType jointStop() {
  return {"joint_stop",
          "A mechanical stop of the joint is not where the model has it.",
          {{"lower", "rad", 0.1, 0, -3, 3, 0.01}, {"upper", "rad", 0, 0, -3, 3, 0.01}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan([joints = setup.hinged(), lower = setup.value("lower"),
                               upper = setup.value("upper")](BodyPlan& plan) {
              for (const std::size_t j : joints) {
                for (const int c : plan.model.actuators[j].coordinates) {
                  Coordinate& hinge = plan.model.coordinates[static_cast<std::size_t>(c)];
                  hinge.lower += lower;
                  hinge.upper += upper;
                }
              }
            });
          }};
}

}  // namespace nao::sim
