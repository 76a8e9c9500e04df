// A reading is now and then one count off: q + amplitude k, k = -1, 0, 0 or 1, each as likely; the
// standard deviation is amplitude / sqrt(2). Source: an angle at the edge between two counts; that
// it is a quarter of the samples is a free choice.
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class EncoderJitter final : public Effect {
 public:
  explicit EncoderJitter(const EffectSetup& setup)
      : joints_(setup.hinged()), amplitude_(setup.value("amplitude")), random_(setup.random) {}

  void alterSensors(SensorFrame& frame, Duration) override {
    for (const std::size_t j : joints_) {
      const double draw = random_.uniform();
      if (draw < 0.25) frame.angle[j] -= amplitude_;
      if (draw >= 0.75) frame.angle[j] += amplitude_;
    }
  }

  void archive(Archive& archive) override { archive.value(random_); }

 private:
  std::vector<std::size_t> joints_;
  double amplitude_;  // [rad]
  Random random_;
};

}  // namespace

EffectType encoderJitter() {
  return {"encoder_jitter",
          "Encoder readings are now and then one count off.",
          {{"amplitude", "rad", 2 * M_PI / 4096, 0, 0, 0.1, 2e-4}},
          Acts::OnSensors,
          makeEffect<EncoderJitter>};
}

}  // namespace nao::sim
