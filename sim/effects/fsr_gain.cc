// The force sensors under both feet exaggerate or understate: f' = gain f, by place; the sums
// follow from these. Source: their spread and wear; Naos are not calibrated one by one.
#include <array>

#include "sim/effects/effect.h"
#include "sim/fsr.h"

namespace nao::sim {
namespace {

class FsrGain final : public Effect {
 public:
  explicit FsrGain(const EffectSetup& setup)
      : feet_(setup.model.feet),
        gain_{setup.value("front_left"), setup.value("front_right"), setup.value("rear_left"),
              setup.value("rear_right")} {}

  void alterSensors(SensorFrame& frame, Duration) override {
    for (std::size_t foot = 0; foot < feet_.size(); ++foot) {
      for (std::size_t i = 0; i < 4; ++i) frame.feet[foot].force[i] *= gain_[i];
      addUp(feet_[foot].fsr, frame.feet[foot]);
    }
  }

 private:
  const std::vector<FootModel>& feet_;
  std::array<double, 4> gain_;
};

}  // namespace

EffectType fsrGain() {
  return {"fsr_gain",
          "The force sensors under the feet exaggerate or understate.",
          {{"front_left", "", 0.9, 1, 0, 10, 0.05},
           {"front_right", "", 1, 1, 0, 10, 0.05},
           {"rear_left", "", 1, 1, 0, 10, 0.05},
           {"rear_right", "", 1, 1, 0, 10, 0.05}},
          Acts::OnSensors,
          makeEffect<FsrGain>};
}

}  // namespace nao::sim
