// A torque that data showed and no law explains: a sum of features of the joint's own motion,
//   T = constant + v v + v_square v|v| + q q + sin_q sin q + cos_q cos q + t t
//     + (sign + q_sign q + sign_sin sin(ripple q) + sign_cos cos(ripple q)
//        + spot exp(-((q - spot_angle) / spot_width)^2)
//        + band exp(-((|v| - band_speed) / band_width)^2)
//        + sign_hum_sin sin(2 pi hum t) + sign_hum_cos cos(2 pi hum t)) sgn v
//     + ripple_sin sin(ripple q) + ripple_cos cos(ripple q)
//     + hum_sin sin(2 pi hum t) + hum_cos cos(2 pi hum t)
//     + (e + t_e t) e + abs_e |e|
// on the link, angles and rates those of the motor, e what its servo is off by, t since the world
// began. What resists is a
// friction, so that the joint sticks and the step stays implicit. No source: it is what a diagnosis
// calls the signature of a remainder, good for predictions like those it was fitted to, and no
// name.
#include <algorithm>
#include <cmath>

#include "sim/effects/effect.h"

namespace nao::sim {
namespace {

constexpr double kSlow = 0.05;  // [rad/s] below which the sign of a rate that pushes fades

class EmpiricalTorque final : public Effect {
 public:
  explicit EmpiricalTorque(const EffectSetup& setup) : joints_(setup.hinged()), c_(setup.values) {}

  void alterDrive(const DriveMoment& moment, DriveTerms& terms) override {
    for (const std::size_t j : joints_) {
      const double q = moment.angle[j], v = moment.rate[j];
      const double t = toSeconds(moment.time), e = moment.command[j] - q;
      terms.disturbance[j] += push(q, t) + (c("e") + c("t_e") * t) * e + c("abs_e") * std::abs(e);
      addDamping(c("v") + c("v_square") * std::abs(v), v, terms, j);
      addSign(dry(q, v) + dryNow(t), v, terms, j);
    }
  }

 private:
  double c(const char* name) const { return c_.at(name); }

  double push(double q, double t) const {
    return c("constant") + c("q") * q + c("sin_q") * std::sin(q) + c("cos_q") * std::cos(q) +
           c("t") * t + c("ripple_sin") * std::sin(c("ripple") * q) +
           c("ripple_cos") * std::cos(c("ripple") * q) +
           c("hum_sin") * std::sin(2 * M_PI * c("hum") * t) +
           c("hum_cos") * std::cos(2 * M_PI * c("hum") * t);
  }

  double dry(double q, double v) const {
    const double spot = (q - c("spot_angle")) / c("spot_width");
    const double band = (std::abs(v) - c("band_speed")) / c("band_width");
    return c("sign") + c("q_sign") * q + c("sign_sin") * std::sin(c("ripple") * q) +
           c("sign_cos") * std::cos(c("ripple") * q) + c("spot") * std::exp(-spot * spot) +
           c("band") * std::exp(-band * band);
  }

  double dryNow(double t) const {
    return c("sign_hum_sin") * std::sin(2 * M_PI * c("hum") * t) +
           c("sign_hum_cos") * std::cos(2 * M_PI * c("hum") * t);
  }

  static void addDamping(double rise, double v, DriveTerms& terms, std::size_t j) {
    terms.viscous[j] += std::max(0.0, -rise);
    terms.disturbance[j] += std::max(0.0, rise) * v;
  }

  static void addSign(double torque, double v, DriveTerms& terms, std::size_t j) {
    terms.resist_forward[j] += std::max(0.0, -torque);
    terms.resist_backward[j] += std::max(0.0, -torque);
    terms.disturbance[j] += std::max(0.0, torque) * std::tanh(v / kSlow);
  }

  std::vector<std::size_t> joints_;
  ParameterValues c_;
};

}  // namespace

EffectType empiricalTorque() {
  return {"empirical_torque",
          "A torque that was measured and has no name: a sum of features of the joint's motion.",
          {{"constant", "N m", 0.1, 0, -50, 50, 0.01},
           {"v", "N m s/rad", 0, 0, -50, 50, 0.01},
           {"v_square", "N m s^2/rad^2", 0, 0, -50, 50, 0.01},
           {"q", "N m/rad", 0, 0, -50, 50, 0.01},
           {"sin_q", "N m", 0, 0, -50, 50, 0.01},
           {"cos_q", "N m", 0, 0, -50, 50, 0.01},
           {"t", "N m/s", 0, 0, -50, 50, 0.01},
           {"e", "N m/rad", 0, 0, -50, 50, 0.1},
           {"abs_e", "N m/rad", 0, 0, -50, 50, 0.1},
           {"t_e", "N m/(rad s)", 0, 0, -50, 50, 0.1},
           {"sign", "N m", 0, 0, -50, 50, 0.01},
           {"q_sign", "N m/rad", 0, 0, -50, 50, 0.01},
           {"sign_sin", "N m", 0, 0, -50, 50, 0.01},
           {"sign_cos", "N m", 0, 0, -50, 50, 0.01},
           {"sign_hum_sin", "N m", 0, 0, -50, 50, 0.01},
           {"sign_hum_cos", "N m", 0, 0, -50, 50, 0.01},
           {"spot", "N m", 0, 0, -50, 50, 0.01},
           {"spot_angle", "rad", 0, 0, -4, 4, 0.02},
           {"spot_width", "rad", 0.12, 0.12, 0.02, 1, 0.02},
           {"band", "N m", 0, 0, -50, 50, 0.01},
           {"band_speed", "rad/s", 1, 1, 0.01, 20, 0.02},
           {"band_width", "rad/s", 0.3, 0.3, 0.01, 5, 0.02},
           {"ripple", "1/rad", 12, 12, 1, 200, 0.1},
           {"ripple_sin", "N m", 0, 0, -50, 50, 0.01},
           {"ripple_cos", "N m", 0, 0, -50, 50, 0.01},
           {"hum", "Hz", 1, 1, 0.01, 100, 0.01},
           {"hum_sin", "N m", 0, 0, -50, 50, 0.01},
           {"hum_cos", "N m", 0, 0, -50, 50, 0.01}},
          Acts::OnDrive,
          makeEffect<EmpiricalTorque>};
}

}  // namespace nao::sim
