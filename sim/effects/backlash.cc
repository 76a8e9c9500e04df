// Play of the gear, seen at the joint: the link moves freely within `width` of the motor, which its
// encoder sees and the servo controls. Law: sim/geared_motor.h.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType backlash() {
  return {
      "backlash",
      "Play between motor and joint: lost motion whenever the load turns round.",
      {{"width", "rad", 0.0175, 0, 0, 0.35, 0.0035}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([joints = setup.hinged(), width = setup.value("width")](BodyPlan& plan) {
          for (const std::size_t j : joints) plan.transmissions[j].play += width;
        });
      }};
}

}  // namespace nao::sim
