// Angles and currents are reported late: q'(t) = q(t - delay), angles by a cubic between cycles
// (half a millirad of a joint that gains speed by 40 rad/s^2 were lost by a line), currents, which
// jump, by a line. The servo is on the motor board and sees them at once. Source: transport over
// the robot's bus.
#include "sim/effects/delay_line.h"
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class SensorDelay final : public Effect {
 public:
  explicit SensorDelay(const EffectSetup& setup)
      : joints_(setup.acting()),
        angle_(joints_.size(), setup.value("delay") / toSeconds(setup.model.cycle)),
        current_(joints_.size(), setup.value("delay") / toSeconds(setup.model.cycle)) {}

  void alterSensors(SensorFrame& frame, Duration) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      angle_.put(i, frame.angle[joints_[i]]);
      current_.put(i, frame.current[joints_[i]]);
      frame.angle[joints_[i]] = angle_.lateSmooth(i);
      frame.current[joints_[i]] = current_.late(i);
    }
    angle_.next();
    current_.next();
  }

  void archive(Archive& archive) override {
    angle_.archive(archive);
    current_.archive(archive);
  }

 private:
  std::vector<std::size_t> joints_;
  DelayLine angle_, current_;
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
