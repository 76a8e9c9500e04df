// The motor's torque does not follow its duty in a straight line, more at small duties: a part of
// the duty d is sign(d) sqrt|d| (law: sim/geared_motor.h). Source: small servos that chop their
// supply; identified on public logs of a Dynamixel XL330 over three gains, where small gains push
// harder than in proportion. The form is one of several that bend so.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType dutyRoot() {
  return {"duty_root",
          "A part of the servo's duty grows with the root of its error instead of the error.",
          {{"part", "", 0.5, 0, 0, 1, 0.02}},
          Acts::Once,
          [](const EffectSetup& setup) {
            return changePlan([joints = setup.hinged(), part = setup.value("part")](BodyPlan& p) {
              for (const std::size_t j : joints)
                p.duty_root[j] = std::min(1.0, p.duty_root[j] + part);
            });
          }};
}

}  // namespace nao::sim
