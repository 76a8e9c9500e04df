// Encoders report whole counts: q_reported = phase + quantum * round((q - phase) / quantum), where
// a zero that was set in software lies `phase` beside a count.
// Source: 12 bit magnetic encoders, 4096 counts a turn (NAOqi 2.1.4.13 documentation, mre).
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class EncoderQuantum final : public Effect {
 public:
  explicit EncoderQuantum(const EffectSetup& setup)
      : phase_(setup.value("phase")), quantum_(setup.joints.size()) {
    for (std::size_t j = 0; j < quantum_.size(); ++j) {
      const bool hinge = !setup.model.actuators[j].coordinates.empty();
      quantum_[j] = setup.joints[j] && hinge ? setup.value("quantum") : 0;
    }
  }

  void alterSensors(SensorFrame& frame, Duration) override {
    for (std::size_t j = 0; j < quantum_.size(); ++j) {
      if (quantum_[j] <= 0) continue;
      const double counts = (frame.angle[j] - phase_) / quantum_[j];
      frame.angle[j] = phase_ + quantum_[j] * std::round(counts);
    }
  }

 private:
  double phase_;                // [rad]
  JointArray<double> quantum_;  // [rad]; 0: none
};

}  // namespace

EffectType encoderQuantum() {
  return {"encoder_quantum",
          "Encoders report whole counts.",
          {{"quantum", "rad", 2 * M_PI / 4096, 0, 0, 0.1, 2e-4},
           {"phase", "rad", 0, 0, -0.1, 0.1, 5e-4}},
          Acts::OnSensors,
          [](const EffectSetup& setup) { return std::make_unique<EncoderQuantum>(setup); }};
}

}  // namespace nao::sim
