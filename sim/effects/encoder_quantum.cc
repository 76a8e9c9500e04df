// Encoders report whole counts: q_reported = quantum * round(q / quantum).
// Source: 12 bit magnetic encoders, 4096 counts a turn (NAOqi 2.1.4.13 documentation, mre).
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class EncoderQuantum final : public Effect {
 public:
  explicit EncoderQuantum(const EffectSetup& setup) : quantum_(setup.joints.size()) {
    for (std::size_t j = 0; j < quantum_.size(); ++j) {
      const bool hinge = !setup.model.actuators[j].coordinates.empty();
      quantum_[j] = setup.joints[j] && hinge ? setup.value("quantum") : 0;
    }
  }

  void alterSensors(SensorFrame& frame, Duration) override {
    for (std::size_t j = 0; j < quantum_.size(); ++j) {
      if (quantum_[j] <= 0) continue;
      frame.angle[j] = quantum_[j] * std::round(frame.angle[j] / quantum_[j]);
    }
  }

 private:
  JointArray<double> quantum_;  // [rad]; 0: none
};

}  // namespace

EffectType encoderQuantum() {
  return {"encoder_quantum",
          "Encoders report whole counts.",
          {{"quantum", "rad", 2 * M_PI / 4096, 0, 0, 0.1, 2e-4}},
          Acts::OnSensors,
          [](const EffectSetup& setup) { return std::make_unique<EncoderQuantum>(setup); }};
}

}  // namespace nao::sim
