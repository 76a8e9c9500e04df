// Angles and currents are reported late: q'(t) = q(t - delay). Of a delay that is no whole number
// of cycles, a reading is that of the cycle before and what the joint has turned by since, step by
// step: no curve through readings knows when a joint starts or stops between them (by one,
// diagnoses told delays 0.3 ms too long). Currents, which jump, run straight between cycles. The
// servo is on the motor board and sees all at once. Source: transport over the robot's bus.
#include <cmath>
#include <utility>
#include <vector>

#include "sim/effects/delay_line.h"
#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

class SensorDelay final : public Effect {
 public:
  explicit SensorDelay(const EffectSetup& setup)
      : SensorDelay(setup.acting(), setup.value("delay") / toSeconds(setup.model.cycle),
                    toSeconds(setup.model.cycle) / toSeconds(setup.step)) {}

  Acts needed(Acts listed) const override { return is_whole_ ? Acts::OnSensors : listed; }

  // At the beginning of a step: what is read after it is a step later.
  void alterDrive(const DriveMoment& moment, DriveTerms&) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      then_.put(i, moment.angle[joints_[i]]);
      before_.put(i, moment.angle[joints_[i]]);
      turned_[i] = then_.late(i) - before_.late(i);
    }
    then_.next();
    before_.next();
  }

  void alterSensors(SensorFrame& frame, Duration) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      angle_.put(i, frame.angle[joints_[i]]);
      current_.put(i, frame.current[joints_[i]]);
      frame.angle[joints_[i]] = angle_.lateWhole(i) + turned_[i];
      frame.current[joints_[i]] = current_.late(i);
    }
    angle_.next();
    current_.next();
  }

  void archive(Archive& archive) override {
    angle_.archive(archive);
    current_.archive(archive);
    then_.archive(archive);
    before_.archive(archive);
    archive.list(turned_);
  }

 private:
  static constexpr double kRounding = 1e-9;

  // `delay` in cycles of `steps` steps.
  SensorDelay(std::vector<std::size_t> joints, double delay, double steps)
      : joints_(std::move(joints)),
        is_whole_(std::abs(delay - std::round(delay)) < kRounding),
        angle_(joints_.size(), std::ceil(delay - kRounding)),
        current_(joints_.size(), delay),
        then_(is_whole_ ? 0 : joints_.size(), delay * steps - 1),
        before_(is_whole_ ? 0 : joints_.size(), std::ceil(delay - kRounding) * steps - 1),
        turned_(joints_.size()) {}

  std::vector<std::size_t> joints_;
  bool is_whole_;               // number of cycles
  DelayLine angle_, current_;   // by cycle
  DelayLine then_, before_;     // by step: when the reading was, and at the cycle before
  std::vector<double> turned_;  // [rad] from that cycle until then
};

}  // namespace

EffectType sensorDelay() {
  return {"sensor_delay",
          "Joint angles and currents are reported late.",
          {{"delay", "s", 0.01, 0, 0, 1, 0.002}},
          Acts::OnDrive | Acts::OnSensors,
          makeEffect<SensorDelay>};
}

}  // namespace nao::sim
