#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/random.h"
#include "validation/diagnosis/causes/causes.h"
#include "validation/diagnosis/ensemble/joint_simulator.h"
#include "validation/diagnosis/rig/led_joint.h"
#include "validation/diagnosis/rig/run_noise.h"

namespace nao::validation::test {

/// What a toy joint consists of; the defaults are its nominal model, about a Nao's knee.
struct ToyLaws {
  double kp = 22, kd = 0.35;         // [N m/rad], [N m s/rad]
  double stall = 3.0, no_load = 8;   // [N m], [rad/s]
  double rotor = 0.007;              // [kg m^2]
  double mass = 0.6, length = 0.15;  // [kg], [m]
  double gravity = 9.81, tilt = 0;   // [m/s^2], [rad]
  double coulomb = 0.08, viscous = 0.03, stribeck = 0, stribeck_speed = 0.1, load = 0;
  double asymmetry = 0, deadband = 0, play = 0, zero = 0, drop = 0, bias = 0;
  double sent = 0;  // [s] between the commands that come, 0: at any time
  double latency = 0.01, hold = 0, filter = 0, rate = 1e9, sensor_delay = 0.005, quantum = 0.0015;
  bool smoothed_first = false;  // of a command that is smoothed and limited
  double stop = -0.9;           // [rad] where it gets no lower
  double spring = 0;            // no cause of toyCauses()
  // No cause of the catalogue below:
  double cogging = 0, cogs = 18, cog_phase = 0, drag = 0, hum = 0, rise = 0, eccentric = 0;
  double spot = 0, band = 0;  // friction near an angle of 0.3 and near a speed of 0.8
  double pulse = 0;           // friction, half a second in every two
  double step = 0.002;        // [s]

  void set(const std::string& effect, const std::map<std::string, double>& p);
};

inline void ToyLaws::set(const std::string& effect, const std::map<std::string, double>& p) {
  const auto at = [&](const char* name) { return p.at(name); };
  if (effect == "coulomb_friction") coulomb = std::max(0.0, coulomb + at("torque"));
  if (effect == "viscous_friction") viscous = std::max(0.0, viscous + at("coefficient"));
  if (effect == "stribeck_friction") stribeck += at("torque"), stribeck_speed = at("speed");
  if (effect == "load_friction") load += at("share");
  if (effect == "friction_asymmetry") asymmetry += at("torque");
  if (effect == "torque_bias") bias += at("torque");
  if (effect == "cable_spring") spring += at("stiffness");
  if (effect == "torque_limit") stall *= at("part");
  if (effect == "voltage_sag") drop += at("drop");
  if (effect == "kp_error") kp *= 1 + at("part");
  if (effect == "kd_error") kd *= 1 + at("part");
  if (effect == "servo_deadband") deadband += at("width");
  if (effect == "motor_inertia") rotor *= 1 + at("part");
  if (effect == "backlash") play += at("width");
  if (effect == "encoder_offset") zero += at("angle");
  if (effect == "joint_stop") stop += at("lower");
  if (effect == "link_mass") mass *= 1 + at("part");
  if (effect == "gravity_scale") gravity *= at("scale");
  if (effect == "ground_tilt") tilt += at("y");
  if (effect == "command_latency") latency = std::max(0.0, latency + at("delay"));
  if (effect == "sensor_delay") sensor_delay = std::max(0.0, sensor_delay + at("delay"));
  if (effect == "command_hold") hold += at("interval");
  if (effect == "command_filter") filter += at("time");
  if (effect == "rate_limit") rate = at("rate"), smoothed_first = filter > 0;
  if (effect == "cogging") {
    cogging += at("torque"), cogs = at("per_turn"), cog_phase = at("phase");
  }
  if (effect == "encoder_quantum") quantum += at("quantum");
}

/// The commands of the toy's motions [rad]: sweeps, triangles, steps and holds of 6 s.
inline double toyCommand(std::size_t motion, double t) {
  const auto triangle = [](double x) { return 2 / M_PI * std::asin(std::sin(x)); };
  switch (motion) {
    case 0:
      return 0.5 + 0.4 * std::sin(2.2 * t) + 0.15 * std::sin(9 * t);
    case 1:
      return 0.2 + 0.5 * triangle(0.8 * t);
    case 2: {
      constexpr double kStops[] = {0, 0.6, -0.3, 0.9, 0.2, -0.6};
      return kStops[std::min(5, static_cast<int>(t))];
    }
    case 3:
      return 0.6 * std::sin(2 * t * (1 + 0.5 * t));
    case 4:
      return -0.2 + 0.8 * triangle(3 * t) * (t / 6);
    case 5:
      return 0.3 + 0.5 * std::sin(1.3 * t) * std::cos(3.1 * t);
    default:
      return 0.4 * triangle(1.5 * t) + (t > 3 ? 0.4 : 0.0);
  }
}

/// One run of one motion: the angle on a grid of 10 ms.
class ToyRun {
 public:
  ToyRun(const ToyLaws& laws, std::size_t motion, const RunDraw& draw, const JointNoise& noise)
      : laws_(laws), motion_(motion), random_(draw.seed, "toy", draw.pair), noise_(noise) {
    start_ = noise.start_sd * random_.normal();
    keep_ = noise.torque_time > 0 ? std::exp(-kAge / noise.torque_time) : 0;
    torque_ = noise.torque_sd * random_.normal();
  }

  Eigen::MatrixXd record(double seconds = 6, double dt = 0.01) {
    const auto rows = static_cast<Eigen::Index>(std::lround(seconds / dt));
    const int steps = static_cast<int>(std::lround(dt / laws_.step));
    Eigen::MatrixXd angle(rows, 1);
    begin();
    for (Eigen::Index row = 0; row < rows; ++row) {
      angle(row, 0) = reading();
      for (int i = 0; i < steps; ++i) step();
    }
    return angle;
  }

  /// By a stiff spring, beside the course that `own` takes.
  LedRun led(ToyRun own, const Eigen::VectorXd& off, const Eigen::VectorXd& misread,
             double dt = 0.01) {
    const Eigen::MatrixXd beside = withRates(off, dt);
    LedRun found{Eigen::VectorXd(off.size()), Eigen::VectorXd(off.size()),
                 Eigen::VectorXd(off.size())};
    own.begin();
    begin();
    const int steps = static_cast<int>(std::lround(dt / laws_.step));
    for (Eigen::Index row = 0; row < off.size(); ++row) {
      double led_by = 0;
      laws_.zero = misread[row];
      found.angle[row] = own.q_;
      trail_.assign(1, q_);
      for (int i = 0; i < steps; ++i, own.step()) {
        led_ = 450 * (own.q_ + beside(row, 0) - q_) + 5 * (own.u_ + beside(row, 1) - u_);
        led_by += led_;
        step();
      }
      found.torque[row] = led_by / steps;
      const double error = commanded_ - q_ - laws_.zero;
      const double torque = laws_.kp * error - laws_.kd * u_;
      const double most = laws_.stall - std::copysign(laws_.stall, torque) * u_ / laws_.no_load;
      found.error[row] = std::abs(torque) < most ? error : 0;
    }
    return found;
  }

 private:
  static constexpr double kAge = 0.004;  // [s] for which the random torque stays

  void begin() {
    q_ = toyCommand(motion_, 0);
    commanded_ = smoothed_ = limited_ = q_;
    trail_.assign(static_cast<std::size_t>(laws_.sensor_delay / laws_.step) + 1, q_ + laws_.zero);
    played_ = q_;
  }

  // Linear between the two nearest steps of the past.
  double reading() const {
    const double late = laws_.sensor_delay / laws_.step;
    const double part = late - std::floor(late);
    const std::size_t n = trail_.size();
    const double newer = trail_[(newest_ + 1) % n];
    const double older = n > 1 ? newer - (trail_[(newest_ + 2) % n] - newer) : newer;
    const double angle = newer + part * (older - newer);
    return laws_.quantum > 0 ? std::round(angle / laws_.quantum) * laws_.quantum : angle;
  }

  double command() {
    double sent = t_ + start_ - laws_.latency;
    if (laws_.hold > 0) sent = std::floor(std::max(sent, 0.0) / laws_.hold) * laws_.hold;
    if (laws_.sent > 0) sent = std::floor(sent / laws_.sent) * laws_.sent;
    double wish = toyCommand(motion_, std::max(0.0, sent));
    if (laws_.smoothed_first) return commanded_ = limited(smoothed(wish));
    return commanded_ = smoothed(limited(wish));
  }

  double limited(double wish) {
    const double most = laws_.rate * laws_.step;
    return limited_ += std::clamp(wish - limited_, -most, most);
  }

  double smoothed(double wish) {
    return smoothed_ += (wish - smoothed_) * laws_.step / (laws_.filter + laws_.step);
  }

  double servo(double error) const {
    const double dead = laws_.deadband;
    if (std::abs(error) <= dead) return -laws_.kd * u_;
    const double kp = laws_.kp * (1 + laws_.rise * t_);  // a gain that grows
    const double torque = kp * (error - std::copysign(dead, error)) - laws_.kd * u_;
    const double level = laws_.stall * (1 - laws_.drop), slope = laws_.stall * u_ / laws_.no_load;
    return std::clamp(torque, std::min(0.0, -level - slope), std::max(0.0, level - slope));
  }

  void step() {
    const double h = laws_.step;
    const double inertia = laws_.rotor + laws_.mass * laws_.length * laws_.length;
    const double weight =
        -laws_.mass * laws_.gravity * laws_.length * std::sin(q_ + laws_.tilt) + laws_.bias;
    const double motor = servo(command() - q_ - misread());
    const double smooth = weight + torque_ + motor + strange() + led_;
    double u = (u_ + h * (smooth) / inertia) / (1 + h * laws_.viscous / inertia);
    const double near = u_ / laws_.stribeck_speed;
    const double dry = laws_.coulomb + laws_.stribeck * std::exp(-near * near) +
                       laws_.load * std::abs(weight) + strangelyDry();
    const double budget =
        dry + (u > 0 ? std::max(0.0, laws_.asymmetry) : std::max(0.0, -laws_.asymmetry));
    u -= std::clamp(u, -h * budget / inertia, h * budget / inertia);
    u_ = u;
    q_ += h * u_;
    if (q_ < laws_.stop) q_ = laws_.stop, u_ = 0;
    t_ += h;
    if (keep_ > 0) {
      torque_ =
          keep_ * torque_ + noise_.torque_sd * std::sqrt(1 - keep_ * keep_) * random_.normal();
    }
    played_ = std::clamp(played_, q_ - laws_.play / 2, q_ + laws_.play / 2);
    newest_ = (newest_ + 1) % trail_.size();
    trail_[newest_] = played_ + misread();
  }

  double misread() const { return laws_.zero + laws_.eccentric * std::sin(3 * q_); }

  double strangelyDry() const {
    const double place = (q_ - 0.3) / 0.12, speed = (std::abs(u_) - 0.8) / 0.25;
    return laws_.spot * std::exp(-place * place) + laws_.band * std::exp(-speed * speed) +
           (std::fmod(t_, 2) < 0.5 ? laws_.pulse : 0);
  }

  double strange() const {
    return laws_.cogging * std::sin(laws_.cogs * q_ + laws_.cog_phase) -
           laws_.drag * u_ * std::abs(u_) - laws_.spring * q_ +
           laws_.hum * std::sin(2 * M_PI * 3.1 * t_);
  }

  ToyLaws laws_;
  std::size_t motion_;
  Random random_;
  JointNoise noise_;
  double start_ = 0, keep_ = 0, torque_ = 0;
  double t_ = 0, q_ = 0, u_ = 0, commanded_ = 0, smoothed_ = 0, limited_ = 0, played_ = 0;
  std::vector<double> trail_;
  std::size_t newest_ = 0;
  double led_ = 0;  // [N m] by which it is led
};

inline const JointNoise kToyNoise{0.03, 0.05, 0.001, 0.0015};

/// A joint of its own laws, integrated in 1 ms: what the statistics are tried on. Its measurements
/// come from `truth`.
class ToyJoint final : public JointSimulator {
 public:
  ToyJoint(const ToyLaws& truth, std::uint64_t seed, const JointNoise& noise = kToyNoise,
           int repeats = 6, std::size_t motions = 5, std::string name = "Toy")
      : name_(std::move(name)), sent_(truth.sent) {
    for (std::size_t m = 0; m < motions; ++m) {
      JointMotion motion{
          "motion" + std::to_string(m), m + 1 < motions ? Split::Fit : Split::Select, 0.01, {}};
      for (int r = 0; r < repeats; ++r) {
        const std::uint64_t stream = 0x5eed0000 + seed * 1000 + m * 100 + static_cast<unsigned>(r);
        motion.repeats.push_back(ToyRun(truth, m, RunDraw{stream}, noise).record());
      }
      measured_.push_back(std::move(motion));
    }
  }

  std::string joint() const override { return name_; }
  const std::vector<JointMotion>& measured() const override { return measured_; }
  Eigen::MatrixXd run(const std::vector<EffectSetting>& causes, std::size_t motion,
                      std::uint64_t stream, const JointNoise& noise) const override {
    ToyLaws laws;
    laws.sent = sent_;
    for (const EffectSetting& cause : causes) laws.set(cause.name, cause.parameters);
    return ToyRun(laws, motion, drawOf(stream, motion), noise).record();
  }
  LedRun led(const std::vector<EffectSetting>& causes, std::size_t motion,
             const Eigen::VectorXd& off, const Eigen::VectorXd& misread) const override {
    ToyLaws laws;
    laws.sent = sent_;
    for (const EffectSetting& cause : causes) laws.set(cause.name, cause.parameters);
    const ToyRun own(laws, motion, RunDraw{}, {});
    return ToyRun(own).led(own, off, misread);
  }
  std::pair<double, double> range() const override {
    return {ToyLaws().stop, std::numeric_limits<double>::infinity()};
  }
  double present(const std::string& effect, const std::string& /*parameter*/) const override {
    const ToyLaws laws;
    if (effect == "coulomb_friction") return laws.coulomb;
    if (effect == "viscous_friction") return laws.viscous;
    if (effect == "command_latency") return laws.latency;
    if (effect == "sensor_delay") return laws.sensor_delay;
    if (effect == "encoder_quantum") return laws.quantum;
    return 0;
  }

 private:
  std::string name_;
  double sent_;  // as ToyLaws: known to whoever replays the commands
  std::vector<JointMotion> measured_;
};

/// The causes whose laws a toy has.
inline std::vector<Cause> toyCauses() {
  std::vector<Cause> causes;
  const std::vector<std::string> known = {
      "coulomb_friction",   "viscous_friction", "stribeck_friction", "load_friction",
      "friction_asymmetry", "torque_bias",      "torque_limit",      "voltage_sag.drop",
      "kp_error",           "kd_error",         "servo_deadband",    "motor_inertia",
      "backlash",           "encoder_offset",   "link_mass",         "gravity_scale",
      "ground_tilt.y",      "command_latency",  "sensor_delay",      "command_hold",
      "command_filter",     "rate_limit",       "encoder_quantum"};
  for (const Cause& cause : jointCauses()) {
    if (std::find(known.begin(), known.end(), cause.id) != known.end()) causes.push_back(cause);
  }
  return causes;
}

}  // namespace nao::validation::test
