// Play of the gear, seen at the joint: the link moves freely within `width` of the motor, which its
// encoder sees and the servo controls. Beyond that its flanks bend by `compliance` T, with the
// damping of gear_compliance; a gear that bends itself is a spring in a row with them. Law:
// sim/geared_motor.h.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

constexpr double kFlankDamping = 0.2;  // [N m s/rad]

void soften(Transmission& gear, double compliance) {
  if (compliance <= 0) return;
  if (gear.stiffness <= 0) gear.damping = kFlankDamping;
  gear.stiffness = 1 / (compliance + (gear.stiffness > 0 ? 1 / gear.stiffness : 0));
}

}  // namespace

EffectType backlash() {
  return {
      "backlash",
      "Play between motor and joint: lost motion whenever the load turns round.",
      {{"width", "rad", 0.0175, 0, 0, 0.35, 0.0035}, {"compliance", "rad/(N m)", 0, 0, 0, 1, 5e-4}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([joints = setup.hinged(), width = setup.value("width"),
                           compliance = setup.value("compliance")](BodyPlan& plan) {
          for (const std::size_t j : joints) {
            plan.transmissions[j].play += width;
            soften(plan.transmissions[j], compliance);
          }
        });
      }};
}

}  // namespace nao::sim
