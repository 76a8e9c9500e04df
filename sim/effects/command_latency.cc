// Commands reach the motors late: c'(t) = c(t - delay). What was sent is kept step by step and read
// between two steps linearly, which is the mean over the step of the delayed staircase; stiffness
// switches at the later of the two.
#include "sim/effects/delay_line.h"
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class CommandLatency final : public Effect {
 public:
  explicit CommandLatency(const EffectSetup& setup)
      : joints_(setup.acting()),
        angle_(joints_.size(), setup.value("delay") / toSeconds(setup.step)),
        stiffness_(joints_.size(), setup.value("delay") / toSeconds(setup.step)) {}

  void alterCommand(JointCommand& command, SimTime, double) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      angle_.put(i, command.angle[joints_[i]]);
      stiffness_.put(i, command.stiffness[joints_[i]]);
      command.angle[joints_[i]] = angle_.late(i);
      command.stiffness[joints_[i]] = stiffness_.lateWhole(i);
    }
    angle_.next();
    stiffness_.next();
  }

  void archive(Archive& archive) override {
    angle_.archive(archive);
    stiffness_.archive(archive);
  }

 private:
  std::vector<std::size_t> joints_;
  DelayLine angle_, stiffness_;
};

}  // namespace

EffectType commandLatency() {
  return {"command_latency",
          "Commands reach the motors late.",
          {{"delay", "s", 0.01, 0, 0, 1, 0.002}},
          Acts::OnCommand,
          makeEffect<CommandLatency>};
}

}  // namespace nao::sim
