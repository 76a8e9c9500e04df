// The servo follows a smoothed command: time y' = c - y, exact for a command held over a step.
// Source: first-order low pass, as motor boards have against steps.
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class CommandFilter final : public Effect {
 public:
  explicit CommandFilter(const EffectSetup& setup)
      : joints_(setup.hinged()), time_(setup.value("time")), angle_(joints_.size()) {
    if (time_ > 0) gain_ = 1 - std::exp(-toSeconds(setup.step) / time_);
  }

  void alterCommand(JointCommand& command, SimTime, double) override {
    if (time_ <= 0) return;
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& angle = command.angle[joints_[i]];
      angle_[i] = begun_ ? angle_[i] + gain_ * (angle - angle_[i]) : angle;
      angle = angle_[i];
    }
    begun_ = true;
  }

  void archive(Archive& archive) override {
    archive.value(begun_);
    archive.list(angle_);
  }

 private:
  std::vector<std::size_t> joints_;
  double time_;      // [s]
  double gain_ = 1;  // of one step
  bool begun_ = false;
  std::vector<double> angle_;  // [rad] filtered
};

}  // namespace

EffectType commandFilter() {
  return {"command_filter",
          "The servo follows a smoothed command.",
          {{"time", "s", 0.02, 0, 0, 2, 0.002}},
          Acts::OnCommand,
          makeEffect<CommandFilter>};
}

}  // namespace nao::sim
