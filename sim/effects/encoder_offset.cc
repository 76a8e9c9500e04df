// The encoder is mounted turned: q_encoder = q + angle, for servo and report alike. Its sign is
// that of the reading. On Naos "1 degree is not exceptional" (NAOqi 2.1.4.13 documentation, mre).
#include "sim/effects/effect.h"

namespace nao::sim {

EffectType encoderOffset() {
  return {
      "encoder_offset",
      "The encoder reads a constant angle too much, and the servo believes it.",
      {{"angle", "rad", 0.01, 0, -1, 1, 0.0035}},
      Acts::Once,
      [](const EffectSetup& setup) {
        return changePlan([joints = setup.hinged(), angle = setup.value("angle")](BodyPlan& plan) {
          for (const std::size_t j : joints) plan.joint_zero[j] -= angle;
        });
      }};
}

}  // namespace nao::sim
