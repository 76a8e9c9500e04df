// A random torque on every link: x' = -x / time + sqrt(2 / time) sd w(t), of standard deviation sd
// and correlation exp(-|t| / time), exact at every step. Source: Ornstein and Uhlenbeck 1930.
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class ProcessNoise final : public Effect {
 public:
  explicit ProcessNoise(const EffectSetup& setup)
      : joints_(setup.hinged()),
        keep_(std::exp(-toSeconds(setup.step) / setup.value("time"))),
        fresh_(setup.value("sd") * std::sqrt(1 - keep_ * keep_)),
        random_(setup.random),
        torque_(joints_.size()) {
    for (double& torque : torque_) torque = setup.value("sd") * random_.normal();
  }

  void alterDrive(const DriveMoment&, DriveTerms& terms) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      terms.disturbance[joints_[i]] += torque_[i];
      torque_[i] = keep_ * torque_[i] + fresh_ * random_.normal();
    }
  }

  void archive(Archive& archive) override {
    archive.value(random_);
    archive.list(torque_);
  }

 private:
  std::vector<std::size_t> joints_;
  double keep_;   // of the torque over a step
  double fresh_;  // [N m]
  Random random_;
  std::vector<double> torque_;  // [N m]
};

}  // namespace

EffectType processNoise() {
  return {"process_noise",
          "A small random torque on every joint, different in every run.",
          {{"sd", "N m", 0.03, 0, 0, 5, 0.005}, {"time", "s", 0.05, 0.05, 1e-3, 10, 0.01}},
          Acts::OnDrive,
          makeEffect<ProcessNoise>};
}

}  // namespace nao::sim
