// The servo does not react to errors up to `width` on either side: T = kp (e -+ width) beyond.
// Law: sim/geared_motor.h.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType servoDeadband() {
  return {
      "servo_deadband",
      "The servo takes small errors for none.",
      {{"width", "rad", 0.005, 0, 0, 0.2, 0.001}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([joints = setup.hinged(), width = setup.value("width")](BodyPlan& plan) {
          for (const std::size_t j : joints) plan.servo_deadband[j] += width;
        });
      }};
}

}  // namespace nao::sim
