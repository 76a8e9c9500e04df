// The servo does not react to errors up to `width` on either side: T = kp (e -+ width) beyond. With
// `ease` it ends without a kink, by a hyperbola that is ease width off the corner. Law:
// sim/geared_motor.h.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType servoDeadband() {
  return {"servo_deadband",
          "The servo takes small errors for none.",
          {{"width", "rad", 0.005, 0, 0, 0.2, 0.001}, {"ease", "", 0, 0, 0, 3, 0.1}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan([joints = setup.hinged(), width = setup.value("width"),
                               ease = setup.value("ease")](BodyPlan& plan) {
              for (const std::size_t j : joints) {
                plan.servo_deadband[j] += width;
                plan.servo_deadband_ease[j] += ease;
              }
            });
          }};
}

}  // namespace nao::sim
