// Angles and currents are reported late: q'(t) = q(t - delay), linear between two cycles. The servo
// is on the motor board and sees them at once. Source: transport over the robot's bus.
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class SensorDelay final : public Effect {
 public:
  explicit SensorDelay(const EffectSetup& setup) : joints_(setup.acting()) {
    const double cycles = setup.value("delay") / toSeconds(setup.model.cycle);
    whole_ = static_cast<std::size_t>(std::floor(cycles + 1e-9));
    part_ = std::fmax(0.0, cycles - static_cast<double>(whole_));
    angle_.resize(joints_.size() * slots());
    current_.resize(angle_.size());
  }

  void alterSensors(SensorFrame& frame, Duration) override {
    if (begun_ == 0) fill(frame);
    store(frame, newest_);
    const std::size_t later = (newest_ + slots() - whole_) % slots() * joints_.size();
    const std::size_t earlier = (newest_ + slots() - whole_ - 1) % slots() * joints_.size();
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      frame.angle[joints_[i]] = between(angle_[later + i], angle_[earlier + i]);
      frame.current[joints_[i]] = between(current_[later + i], current_[earlier + i]);
    }
    newest_ = (newest_ + 1) % slots();
  }

  void archive(Archive& archive) override {
    archive.value(newest_);
    archive.value(begun_);
    archive.list(angle_);
    archive.list(current_);
  }

 private:
  std::size_t slots() const { return whole_ + 2; }
  double between(double later, double earlier) const { return later + part_ * (earlier - later); }

  void fill(const SensorFrame& frame) {
    for (std::size_t slot = 0; slot < slots(); ++slot) store(frame, slot);
    begun_ = 1;
  }

  void store(const SensorFrame& frame, std::size_t slot) {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      angle_[slot * joints_.size() + i] = frame.angle[joints_[i]];
      current_[slot * joints_.size() + i] = frame.current[joints_[i]];
    }
  }

  std::vector<std::size_t> joints_;
  std::size_t whole_ = 0;                // cycles of delay
  double part_ = 0;                      // of one cycle more
  std::size_t newest_ = 0;               // slot to be filled next
  std::size_t begun_ = 0;                // 0: nothing was read yet
  std::vector<double> angle_, current_;  // by slot, then by joint
};

}  // namespace

EffectType sensorDelay() {
  return {"sensor_delay",
          "Joint angles and currents are reported late.",
          {{"delay", "s", 0.01, 0, 0, 1, 0.002}},
          Acts::OnSensors,
          makeEffect<SensorDelay>};
}

}  // namespace nao::sim
