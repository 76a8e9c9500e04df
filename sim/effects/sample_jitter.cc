// Angles are measured up to `span` before the time they are reported for: q'(t) = q(t - d), d drawn
// for every cycle from U(0, span), linear between two cycles, the same for all joints. `span`
// beyond one cycle counts as one. Source: a bus that is polled next to other work.
#include <algorithm>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class SampleJitter final : public Effect {
 public:
  explicit SampleJitter(const EffectSetup& setup)
      : joints_(setup.hinged()),
        span_(setup.value("span")),
        random_(setup.random),
        angle_(joints_.size()) {}

  void alterSensors(SensorFrame& frame, Duration cycle) override {
    const double part = random_.uniform() * std::min(1.0, span_ / toSeconds(cycle));
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& angle = frame.angle[joints_[i]];
      const double before = begun_ ? angle_[i] : angle;
      angle_[i] = angle;
      angle += part * (before - angle);
    }
    begun_ = true;
  }

  void archive(Archive& archive) override {
    archive.value(random_);
    archive.value(begun_);
    archive.list(angle_);
  }

 private:
  std::vector<std::size_t> joints_;
  double span_;  // [s]
  Random random_;
  bool begun_ = false;
  std::vector<double> angle_;  // [rad] true, of the cycle before
};

}  // namespace

EffectType sampleJitter() {
  return {"sample_jitter",
          "Angles are measured a random moment before the time they are reported for.",
          {{"span", "s", 0.005, 0, 0, 1, 0.001}},
          Acts::OnSensors,
          makeEffect<SampleJitter>};
}

}  // namespace nao::sim
