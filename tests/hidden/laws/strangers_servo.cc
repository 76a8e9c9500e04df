// Servos and encoders with faults that no entry of the catalogue stands for.
#include <algorithm>
#include <cmath>

#include "tests/hidden/laws/laws.h"

namespace nao::hidden {
namespace {

constexpr sim::Acts kServo = sim::Acts::OnCommand | sim::Acts::OnDrive;

// The command has play: what follows it stays until it is pushed by either end.
class CommandHysteresis final : public sim::Effect {
 public:
  explicit CommandHysteresis(const sim::EffectSetup& setup)
      : joints_(setup.hinged()), half_(std::abs(setup.value("size")) / 2), value_(joints_.size()) {}

  void alterCommand(JointCommand& command, SimTime, double) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& followed = command.angle[joints_[i]];
      if (begun_ == 0) value_[i] = followed;
      value_[i] = std::clamp(value_[i], followed - half_, followed + half_);
      followed = value_[i];
    }
    begun_ = 1;
  }

  void archive(Archive& archive) override {
    archive.value(begun_);
    archive.list(value_);
  }

 private:
  std::vector<std::size_t> joints_;
  double half_;  // [rad]
  std::uint64_t begun_ = 0;
  std::vector<double> value_;  // [rad]
};

// The encoder's magnet turns about a point beside its centre: it reads q + size sin(n q), and the
// servo believes it.
class EccentricEncoder final : public sim::Effect {
 public:
  explicit EccentricEncoder(const sim::EffectSetup& setup)
      : joints_(setup.hinged()),
        size_(setup.value("size")),
        per_radian_(setup.value("per_radian")),
        angle_(joints_.size()) {}

  void alterCommand(JointCommand& command, SimTime, double) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) command.angle[joints_[i]] -= error(angle_[i]);
  }
  void alterDrive(const sim::DriveMoment& moment, sim::DriveTerms&) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) angle_[i] = moment.angle[joints_[i]];
  }
  void alterSensors(SensorFrame& frame, Duration) override {
    for (const std::size_t j : joints_) frame.angle[j] += error(frame.angle[j]);
  }
  void archive(Archive& archive) override { archive.list(angle_); }

 private:
  double error(double angle) const { return size_ * std::sin(per_radian_ * angle); }

  std::vector<std::size_t> joints_;
  double size_;                // [rad]
  double per_radian_;          // [1/rad]
  std::vector<double> angle_;  // [rad] of the step before
};

}  // namespace

sim::EffectType oneSidedGain() {
  return {"hidden_one_sided_gain",
          "A bridge that pushes one way harder than the other.",
          {{"size", "", 0.2, 0, -0.9, 20, 0}},
          kServo,
          [](const sim::EffectSetup& setup) {
            return servoLaw(setup, [part = setup.value("size")](const ServoMoment& servo) {
              return servo.error > 0 ? servo.error * (1 + part) : servo.error;
            });
          }};
}

sim::EffectType driftingGain() {
  return {"hidden_drifting_gain",
          "A gain that grows, or fades, as the run goes on.",
          {{"size", "1/s", 0.05, 0, -0.15, 20, 0}},
          kServo,
          [](const sim::EffectSetup& setup) {
            return servoLaw(setup, [part = setup.value("size")](const ServoMoment& servo) {
              return servo.error * (1 + part * std::max(0.0, servo.time));
            });
          }};
}

sim::EffectType commandHysteresis() {
  return {"hidden_command_hysteresis",
          "A command that has play.",
          {{"size", "rad", 0.02, 0, -0.5, 0.5, 0}},
          sim::Acts::OnCommand,
          sim::makeEffect<CommandHysteresis>};
}

sim::EffectType eccentricEncoder() {
  return {"hidden_eccentric_encoder",
          "An encoder that reads too much here and too little there.",
          {{"size", "rad", 0.02, 0, -0.3, 0.3, 0}, {"per_radian", "1/rad", 3, 3, 0.1, 20, 0}},
          kServo | sim::Acts::OnSensors,
          sim::makeEffect<EccentricEncoder>};
}

}  // namespace nao::hidden
