// The force sensors under both feet feel nothing below a threshold: f' = f if f >= force, else 0.
// Source: resistive foils need a first pressure before they conduct.
#include "sim/effects/effect.h"
#include "sim/fsr.h"

namespace nao::sim {
namespace {

class FsrThreshold final : public Effect {
 public:
  explicit FsrThreshold(const EffectSetup& setup)
      : feet_(setup.model.feet), threshold_(setup.value("force")) {}

  void alterSensors(SensorFrame& frame, Duration) override {
    for (std::size_t foot = 0; foot < feet_.size(); ++foot) {
      for (double& force : frame.feet[foot].force) {
        if (force < threshold_) force = 0;
      }
      addUp(feet_[foot].fsr, frame.feet[foot]);
    }
  }

 private:
  const std::vector<FootModel>& feet_;
  double threshold_;  // [N]
};

}  // namespace

EffectType fsrThreshold() {
  return {"fsr_threshold",
          "The force sensors under the feet feel nothing below a threshold.",
          {{"force", "N", 1, 0, 0, 25, 0.2}},
          Acts::OnSensors,
          makeEffect<FsrThreshold>};
}

}  // namespace nao::sim
