// New commands are taken over only every `interval`, and held between: a staircase that is late by
// interval / 2 on average. Source: the status interval of a simulator, the cycle of a motor bus.
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class CommandHold final : public Effect {
 public:
  explicit CommandHold(const EffectSetup& setup)
      : joints_(setup.acting()), interval_(setup.value("interval")) {}

  void alterCommand(JointCommand& command, SimTime, double h) override {
    if (interval_ <= 0) return;
    if (left_ <= h / 2) {
      held_ = command;
      left_ += interval_;
    }
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
  double left_ = 0;  // [s] until the next command is taken over
  JointCommand held_;
};

}  // namespace

EffectType commandHold() {
  return {"command_hold",
          "New commands are taken over only now and then, and held between.",
          {{"interval", "s", 0.04, 0, 0, 2, 0.005}},
          Acts::OnCommand,
          makeEffect<CommandHold>};
}

}  // namespace nao::sim
