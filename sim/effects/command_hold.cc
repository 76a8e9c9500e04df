// New commands are taken over only every `interval`, and held between: a staircase that is late by
// interval / 2 on average. The first is held until `phase` has passed, where the clock first ticks.
// Source: the status interval of a simulator, the cycle of a motor bus.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class CommandHold final : public Effect {
 public:
  explicit CommandHold(const EffectSetup& setup)
      : joints_(setup.acting()), interval_(setup.value("interval")), left_(setup.value("phase")) {}

  void alterCommand(JointCommand& command, SimTime, double h) override {
    if (interval_ <= 0) return;
    const bool ticks = left_ <= h / 2;
    if (ticks || held_.angle.size() == 0) held_ = command;
    if (ticks) left_ += interval_;
    left_ -= h;
    for (const std::size_t j : joints_) {
      command.angle[j] = held_.angle[j];
      command.stiffness[j] = held_.stiffness[j];
    }
  }

  void archive(Archive& archive) override {
    archive.value(left_);
    archive.value(held_.angle);
    archive.value(held_.stiffness);
  }

 private:
  std::vector<std::size_t> joints_;
  double interval_;  // [s]
  double left_;      // [s] until the next command is taken over
  JointCommand held_;
};

}  // namespace

EffectType commandHold() {
  return {"command_hold",
          "New commands are taken over only now and then, and held between.",
          {{"interval", "s", 0.04, 0, 0, 2, 0.005}, {"phase", "s", 0, 0, 0, 2, 0.001}},
          Acts::OnCommand,
          makeEffect<CommandHold>};
}

}  // namespace nao::sim
