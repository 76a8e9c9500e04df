// The command that the servo follows moves no faster than `rate`: |dc/dt| <= rate; with `ease` it
// arrives gently, ease c' = wanted - c, exact for a command held over a step.
// Source: motor boards that ramp their set point.
#include <algorithm>
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

constexpr double kUnlimited = 1e4;   // [rad/s] 20 rad in one 2 ms step: no command asks for it
constexpr double kMostEase = 0.002;  // [s] what takes longer is a filter (command_filter.cc)

class RateLimit final : public Effect {
 public:
  explicit RateLimit(const EffectSetup& setup)
      : joints_(setup.hinged()), rate_(setup.value("rate")), angle_(joints_.size()) {
    const double ease = setup.value("ease");
    if (ease > 0) gain_ = 1 - std::exp(-toSeconds(setup.step) / ease);
  }

  void alterCommand(JointCommand& command, SimTime, double h) override {
    if (rate_ >= kUnlimited) return;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& wanted = command.angle[joints_[i]];
      const double way = gain_ * (wanted - angle_[i]);
      if (begun_) wanted = angle_[i] + std::clamp(way, -rate_ * h, rate_ * h);
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
  double rate_;      // [rad/s]
  double gain_ = 1;  // of one step
  bool begun_ = false;
  std::vector<double> angle_;  // [rad] followed last
};

}  // namespace

EffectType rateLimit() {
  return {"rate_limit",
          "The command that the servo follows moves no faster than this.",
          {{"rate", "rad/s", 3, kUnlimited, 0.01, kUnlimited, 0.1},
           {"ease", "s", 0, 0, 0, kMostEase, 0.0005}},
          Acts::OnCommand,
          makeEffect<RateLimit>};
}

}  // namespace nao::sim
