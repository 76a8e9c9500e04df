// A constant torque on the joint, whatever it does: a pull that nothing else accounts for.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class TorqueBias final : public Effect {
 public:
  explicit TorqueBias(const EffectSetup& setup)
      : joints_(setup.hinged()), torque_(setup.value("torque")) {}

  void alterDrive(const DriveMoment&, DriveTerms& terms) override {
    for (const std::size_t j : joints_) terms.disturbance[j] += torque_;
  }

 private:
  std::vector<std::size_t> joints_;
  double torque_;  // [N m]
};

}  // namespace

EffectType torqueBias() {
  return {"torque_bias",
          "A constant torque pulls at the joint.",
          {{"torque", "N m", 0.05, 0, -10, 10, 0.01}},
          Acts::OnDrive,
          makeEffect<TorqueBias>};
}

}  // namespace nao::sim
