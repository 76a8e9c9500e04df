// Delays, holds and filters of the catalogue by other laws: messages under way with the time they
// were sent, clocks, two poles.
#include <algorithm>
#include <cmath>
#include <deque>

#include "tests/hidden/laws/laws.h"

namespace nao::hidden {
namespace {

// A message is a command that differs from the one before; it arrives `delay` after it was sent.
class MessageLatency final : public sim::Effect {
 public:
  explicit MessageLatency(const sim::EffectSetup& setup)
      : joints_(setup.acting()), delay_(fromSeconds(setup.value("delay"))) {}

  void alterCommand(JointCommand& command, SimTime now, double) override {
    const Message sent{now, command};
    if (under_way_.empty()) {
      arrived_ = command;
      under_way_.push_back(sent);
    } else if (differs(under_way_.back().command, command)) {
      under_way_.push_back(sent);
    }
    for (const Message& message : under_way_) {
      if (message.time + delay_ <= now) arrived_ = message.command;
    }
    while (under_way_.size() > 1 && under_way_[1].time + delay_ <= now) under_way_.pop_front();
    for (const std::size_t j : joints_) command.angle[j] = arrived_.angle[j];
  }

  // A run is never taken up in the middle: only its beginning, where nothing is under way.
  void archive(Archive& archive) override {
    if (archive.mode() == Archive::Mode::Load) under_way_.clear();
  }

 private:
  struct Message {
    SimTime time;
    JointCommand command;
  };
  static bool differs(const JointCommand& a, const JointCommand& b) {
    return !std::equal(a.angle.begin(), a.angle.end(), b.angle.begin());
  }

  std::vector<std::size_t> joints_;
  Duration delay_;
  std::deque<Message> under_way_;
  JointCommand arrived_;
};

// New commands are taken over at whole multiples of `interval` of the robot's own clock.
class ClockedHold final : public sim::Effect {
 public:
  explicit ClockedHold(const sim::EffectSetup& setup)
      : joints_(setup.acting()), interval_(setup.value("interval")) {}

  void alterCommand(JointCommand& command, SimTime now, double) override {
    if (interval_ <= 0) return;
    const double tick = std::floor(toSeconds(now) / interval_ + 1e-9);
    if (tick != tick_) held_ = command;
    tick_ = tick;
    for (const std::size_t j : joints_) command.angle[j] = held_.angle[j];
  }

  void archive(Archive& archive) override {
    archive.value(tick_);
    archive.value(held_.angle);
    archive.value(held_.stiffness);
  }

 private:
  std::vector<std::size_t> joints_;
  double interval_;   // [s]
  double tick_ = -1;  // of the clock, last
  JointCommand held_;
};

// Readings are stored and sent `delay` later, on top of the model's own delay: angles of every
// step, in whole counts, currents of every cycle, between which they are taken to run straight.
class LateReading final : public sim::Effect {
 public:
  explicit LateReading(const sim::EffectSetup& setup)
      : joints_(setup.hinged()),
        late_(setup.value("delay")),
        step_(toSeconds(setup.step)),
        cycle_(toSeconds(setup.model.cycle)) {
    for (const EffectSetting& own : setup.model.effects) {
      if (own.name == "sensor_delay") own_ += own.parameters.at("delay");
      if (own.name == "encoder_quantum") quantum_ = own.parameters.at("quantum");
    }
    angle_.resize(joints_.size());
    current_.resize(joints_.size());
  }

  void alterDrive(const sim::DriveMoment& moment, sim::DriveTerms&) override {
    for (std::size_t i = 0; i < joints_.size(); ++i) angle_[i].push_back(moment.angle[joints_[i]]);
  }

  void alterSensors(SensorFrame& frame, Duration) override {
    for (std::size_t i = 0; i < joints_.size() && !angle_[i].empty(); ++i) {
      const double reading = at(angle_[i], own_ + late_ - step_);  // the latest is a step old
      frame.angle[joints_[i]] = quantum_ > 0 ? quantum_ * std::round(reading / quantum_) : reading;
      current_[i].push_back(frame.current[joints_[i]]);
      frame.current[joints_[i]] = between(current_[i], late_ / cycle_);
    }
  }

  void archive(Archive& archive) override {
    for (std::vector<double>& angles : angle_) archive.list(angles);
    for (std::vector<double>& currents : current_) archive.list(currents);
  }

 private:
  double at(const std::vector<double>& angles, double ago) const {
    const auto steps = static_cast<std::size_t>(std::lround(std::max(0.0, ago) / step_));
    return angles[angles.size() - 1 - std::min(steps, angles.size() - 1)];
  }

  static double between(const std::vector<double>& values, double ago) {
    const double place = std::max(0.0, static_cast<double>(values.size() - 1) - ago);
    const auto before = static_cast<std::size_t>(place);
    const std::size_t after = std::min(before + 1, values.size() - 1);
    return values[before] +
           (place - static_cast<double>(before)) * (values[after] - values[before]);
  }

  std::vector<std::size_t> joints_;
  double late_, step_, cycle_, own_ = 0;      // [s]
  double quantum_ = 0;                        // [rad]
  std::vector<std::vector<double>> angle_;    // [rad] of all steps, by joint
  std::vector<std::vector<double>> current_;  // [A] of all cycles
};

// Each command passes through stages of memory: next = law(last value, input).
template <int Stages>
class Memory : public sim::Effect {
 public:
  explicit Memory(const sim::EffectSetup& setup)
      : joints_(setup.hinged()), value_(Stages * joints_.size()) {}

  void alterCommand(JointCommand& command, SimTime, double h) final {
    for (std::size_t i = 0; i < joints_.size(); ++i) {
      double& followed = command.angle[joints_[i]];
      for (std::size_t stage = 0; stage < Stages; ++stage) {
        double& value = value_[Stages * i + stage];
        value = begun_ != 0 ? next(static_cast<int>(stage), value, followed, h) : followed;
        followed = value;
      }
    }
    begun_ = 1;
  }

  void archive(Archive& archive) final {
    archive.value(begun_);
    archive.list(value_);
  }

 protected:
  virtual double next(int stage, double value, double input, double h) const = 0;

 private:
  std::vector<std::size_t> joints_;
  std::uint64_t begun_ = 0;
  std::vector<double> value_;  // [rad]
};

class TwoPoleFilter final : public Memory<2> {
 public:
  explicit TwoPoleFilter(const sim::EffectSetup& setup)
      : Memory(setup), time_(setup.value("time")) {}

 private:
  // Nearly all of the lag in one pole, the rest in a second: together `time`.
  double next(int stage, double value, double input, double h) const override {
    const double time = std::max(1e-6, (stage == 0 ? 0.9 : 0.1) * time_);
    return value + (input - value) * h / (h + time);
  }
  double time_;  // [s]
};

class EasedRateLimit final : public Memory<1> {
 public:
  explicit EasedRateLimit(const sim::EffectSetup& setup)
      : Memory(setup), rate_(setup.value("rate")) {}

 private:
  // Eases in over the last 1 ms of its way.
  double next(int, double value, double input, double h) const override {
    constexpr double kEase = 0.001;  // [s] half of what anybody cares about
    return value + std::clamp((input - value) * h / (h + kEase), -rate_ * h, rate_ * h);
  }
  double rate_;  // [rad/s]
};

}  // namespace

sim::EffectType messageLatency() {
  return {"hidden_message_latency",
          "Commands are messages that arrive late.",
          {{"delay", "s", 0.01, 0, 0, 1, 0}},
          sim::Acts::OnCommand,
          sim::makeEffect<MessageLatency>};
}

sim::EffectType clockedHold() {
  return {"hidden_clocked_hold",
          "Commands are taken over when the robot's own clock ticks.",
          {{"interval", "s", 0.04, 0, 0, 2, 0}},
          sim::Acts::OnCommand,
          sim::makeEffect<ClockedHold>};
}

sim::EffectType lateReading() {
  return {"hidden_late_reading",
          "Angles are stored and sent late.",
          {{"delay", "s", 0.01, 0, 0, 1, 0}},
          sim::Acts::OnDrive | sim::Acts::OnSensors,
          sim::makeEffect<LateReading>};
}

sim::EffectType twoPoleFilter() {
  return {"hidden_two_pole_filter",
          "Commands are smoothed twice.",
          {{"time", "s", 0.02, 0, 0, 2, 0}},
          sim::Acts::OnCommand,
          sim::makeEffect<TwoPoleFilter>};
}

sim::EffectType easedRateLimit() {
  return {"hidden_eased_rate_limit",
          "The command moves no faster than this and arrives gently.",
          {{"rate", "rad/s", 3, 1e4, 0.01, 1e4, 0}},
          sim::Acts::OnCommand,
          sim::makeEffect<EasedRateLimit>};
}

sim::EffectType smoothDeadband() {
  return {"hidden_smooth_deadband",
          "A servo that is deaf to small errors, without a kink.",
          {{"width", "rad", 0.005, 0, 0, 0.2, 0}},
          sim::Acts::OnCommand | sim::Acts::OnDrive,
          [](const sim::EffectSetup& setup) {
            return servoLaw(setup, [width = setup.value("width")](const ServoMoment& servo) {
              if (width <= 0) return servo.error;
              return servo.error - width * std::tanh(servo.error / width);
            });
          }};
}

}  // namespace nao::hidden
