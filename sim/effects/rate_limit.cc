// The command that the servo follows moves no faster than `rate`: |dc/dt| <= rate.
// Source: motor boards that ramp their set point.
#include <algorithm>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

constexpr double kUnlimited = 1e4;  // [rad/s] 20 rad in one 2 ms step: no command asks for it

class RateLimit final : public Effect {
 public:
  explicit RateLimit(const EffectSetup& setup)
      : joints_(setup.hinged()), rate_(setup.value("rate")), angle_(joints_.size()) {}

  void alterCommand(JointCommand& command, SimTime, double h) override {
    if (rate_ >= kUnlimited) return;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& wanted = command.angle[joints_[i]];
      if (begun_) wanted = angle_[i] + std::clamp(wanted - angle_[i], -rate_ * h, rate_ * h);
      angle_[i] = wanted;
    }
    begun_ = true;
  }

  void archive(Archive& archive) override {
    archive.value(begun_);
    archive.list(angle_);
  }

 private:
  std::vector<std::size_t> joints_;
  double rate_;  // [rad/s]
  bool begun_ = false;
  std::vector<double> angle_;  // [rad] followed last
};

}  // namespace

EffectType rateLimit() {
  return {"rate_limit",
          "The command that the servo follows moves no faster than this.",
          {{"rate", "rad/s", 3, kUnlimited, 0.01, kUnlimited, 0.1}},
          Acts::OnCommand,
          makeEffect<RateLimit>};
}

}  // namespace nao::sim
