// Commands reach the motors late: c'(t) = c(t - delay). What was sent is kept step by step and read
// between two steps linearly, which is the mean over the step of the delayed staircase; stiffness
// switches at the later of the two.
#include <algorithm>
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class CommandLatency final : public Effect {
 public:
  explicit CommandLatency(const EffectSetup& setup) : joints_(setup.acting()) {
    const double steps = setup.value("delay") / toSeconds(setup.step);
    whole_ = static_cast<std::size_t>(std::floor(steps + 1e-9));
    part_ = std::max(0.0, steps - static_cast<double>(whole_));
    angle_.resize(joints_.size() * slots());
    stiffness_.resize(angle_.size());
  }

  void alterCommand(JointCommand& command, SimTime, double) override {
    if (begun_ == 0) fill(command);
    store(command, newest_);
    const std::size_t later = (newest_ + slots() - whole_) % slots();
    const std::size_t earlier = (newest_ + slots() - whole_ - 1) % slots();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      const double angle = angle_[later * joints_.size() + i];
      const double before = angle_[earlier * joints_.size() + i];
      command.angle[joints_[i]] = angle + part_ * (before - angle);
      command.stiffness[joints_[i]] = stiffness_[later * joints_.size() + i];
    }
    newest_ = (newest_ + 1) % slots();
  }

  void archive(Archive& archive) override {
    archive.value(newest_);
    archive.value(begun_);
    archive.list(angle_);
    archive.list(stiffness_);
  }

 private:
  std::size_t slots() const { return whole_ + 2; }

  void fill(const JointCommand& command) {
    for (std::size_t slot = 0; slot < slots(); ++slot) store(command, slot);
    begun_ = 1;
  }

  void store(const JointCommand& command, std::size_t slot) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      angle_[slot * joints_.size() + i] = command.angle[joints_[i]];
      stiffness_[slot * joints_.size() + i] = command.stiffness[joints_[i]];
    }
  }

  std::vector<std::size_t> joints_;
  std::size_t whole_ = 0;                  // steps of delay
  double part_ = 0;                        // of one step more
  std::size_t newest_ = 0;                 // slot to be filled next
  std::size_t begun_ = 0;                  // 0: nothing was sent yet
  std::vector<double> angle_, stiffness_;  // by slot, then by joint
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
