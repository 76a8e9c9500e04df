// Whether the joints meet the limits that depend on another joint: on >= 0.5 yes, else no, like the
// simulator of the thesis, which had none. Commands are clipped all the same.
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType coupledLimits() {
  return {
      "coupled_limits",
      "Whether joints meet the limits that depend on another joint.",
      {{"on", "", 0, 1, 0, 1, 1}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([joints = setup.joints, off = setup.value("on") < 0.5](BodyPlan& plan) {
          if (!off) return;
          for (CoupledLimit& limit : plan.model.coupled_limits) {
            if (joints[limit.limited]) limit.stop = false;
          }
        });
      }};
}

}  // namespace nao::sim
