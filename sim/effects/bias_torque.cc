// A constant torque on the link, as of a cable that pulls: T = torque, towards larger angles if >
// 0.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class BiasTorque final : public Effect {
 public:
  explicit BiasTorque(const EffectSetup& setup)
      : joints_(setup.hinged()), torque_(setup.value("torque")) {}

  void alterDrive(const DriveMoment&, DriveTerms& terms) override {
    for (const std::size_t j : joints_) terms.disturbance[j] += torque_;
  }

 private:
  std::vector<std::size_t> joints_;
  double torque_;  // [N m]
};

}  // namespace

EffectType biasTorque() {
  return {"bias_torque",
          "Something pulls a joint with a constant torque.",
          {{"torque", "N m", 0.1, 0, -10, 10, 0.01}},
          Acts::OnDrive,
          makeEffect<BiasTorque>};
}

}  // namespace nao::sim
