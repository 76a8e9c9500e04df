#include "validation/diagnosis/joint/torque_features.h"

#include <cmath>
#include <cstdio>

namespace nao::validation {
namespace {

constexpr int kFirstRipple = 3, kLastRipple = 40;  // periods in 2 pi of the joint
constexpr int kLastPatch = 16;                     // of a friction's
constexpr int kLastEccentric = 12;                 // of an encoder's error
constexpr int kFirstHum = 5, kLastHum = 100;       // [0.1 Hz]
constexpr int kFirstPulse = 2, kLastPulse = 30;    // [0.1 Hz] of a friction that comes and goes
constexpr double kSlow = 0.05;                     // [rad/s] below which the sign of v fades
constexpr int kLastSpot = 22;                      // [0.1 rad] either way
constexpr double kSpot = 0.12;                     // [rad] its width
constexpr int kBands = 11;                         // of speed, from the first on,
constexpr double kFirstBand = 0.15, kNextBand = 1.4, kBand = 0.3;  // [rad/s], times, its width

double bell(double x) { return std::exp(-x * x); }

double bandSpeed(int i) { return kFirstBand * std::pow(kNextBand, i); }

struct Moment {
  double q, v, a, t, e;  // angle, rate, second rate, time, what the servo is off by
};

double sign(double v) { return std::tanh(v / kSlow); }

struct Simple {
  const char* name;
  double (*of)(const Moment&);
};
constexpr Simple kSimple[] = {
    {"1", [](const Moment&) { return 1.0; }},
    {"sgn v", [](const Moment& m) { return sign(m.v); }},
    {"v", [](const Moment& m) { return m.v; }},
    {"v|v|", [](const Moment& m) { return m.v * std::abs(m.v); }},
    {"q", [](const Moment& m) { return m.q; }},
    {"a", [](const Moment& m) { return m.a; }},
    {"q sgn v", [](const Moment& m) { return m.q * sign(m.v); }},
    {"t", [](const Moment& m) { return m.t; }},
    {"e", [](const Moment& m) { return m.e; }},
    {"|e|", [](const Moment& m) { return std::abs(m.e); }},
    {"t e", [](const Moment& m) { return m.t * m.e; }},
};

}  // namespace

TorqueFeatures::TorqueFeatures() {
  for (const Simple& one : kSimple) add(one.name, 1);
  add("sin and cos of q", 2);
  const auto harmonic = [](int n) { return "sin and cos of " + std::to_string(n) + " q"; };
  for (int n = kFirstRipple; n <= kLastRipple; ++n) {
    add(harmonic(n), 2);
    features_.back().periods = n;
  }
  for (int n = 1; n <= kLastPatch; ++n) add("sgn v with " + harmonic(n), 3);
  addDryPlaces();
  char text[40];
  for (int f = kFirstHum; f <= kLastHum; ++f) {
    std::snprintf(text, sizeof text, "sin and cos of %.1f Hz", 0.1 * f);
    add(text, 2);
  }
  for (int f = kFirstPulse; f <= kLastPulse; ++f) {
    std::snprintf(text, sizeof text, "sgn v with sin and cos of %.1f Hz", 0.1 * f);
    add(text, 3);
  }
  const Eigen::Index torques = columns_;
  for (int n = 1; n <= kLastEccentric; ++n) add("misreading by " + harmonic(n), 2);
  misreadings_ = columns_ - torques;
}

// Friction near an angle, and near a speed.
void TorqueFeatures::addDryPlaces() {
  char text[40];
  for (int n = -kLastSpot; n <= kLastSpot; ++n) {
    std::snprintf(text, sizeof text, "sgn v near q = %.1f", 0.1 * n);
    add(text, 1);
  }
  for (int i = 0; i < kBands; ++i) {
    std::snprintf(text, sizeof text, "sgn v near |v| = %.2f", bandSpeed(i));
    add(text, 1);
  }
}

Eigen::VectorXd TorqueFeatures::misreading(Eigen::Index i, const Eigen::VectorXd& angle) const {
  const Eigen::ArrayXd turned = static_cast<double>(i / 2 + 1) * angle.array();
  if (i % 2 == 0) return turned.sin();
  return turned.cos();
}

void TorqueFeatures::add(const std::string& name, Eigen::Index columns) {
  features_.push_back({name, {}});
  for (Eigen::Index i = 0; i < columns; ++i) features_.back().columns.push_back(columns_++);
}

Eigen::MatrixXd TorqueFeatures::along(const Eigen::MatrixXd& motion, const Eigen::VectorXd& error,
                                      double dt) const {
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(motion.rows(), columns_);
  for (Eigen::Index i = 0; i < motion.rows(); ++i) {
    const double q = motion(i, 0), t = dt * static_cast<double>(i);
    const Moment moment{q, motion(i, 1), motion(i, 2), t, error[i]};
    Eigen::Index at = 0;
    for (const Simple& one : kSimple) all(i, at++) = one.of(moment);
    const auto wave = [&](double angle) {
      all(i, at++) = std::sin(angle);
      all(i, at++) = std::cos(angle);
    };
    wave(q);
    for (int n = kFirstRipple; n <= kLastRipple; ++n) wave(n * q);
    const auto dry = [&](double angle) {
      for (const double part : {1.0, std::sin(angle), std::cos(angle)}) {
        all(i, at++) = part * sign(moment.v);
      }
    };
    for (int n = 1; n <= kLastPatch; ++n) dry(n * q);
    for (int n = -kLastSpot; n <= kLastSpot; ++n) {
      all(i, at++) = bell((q - 0.1 * n) / kSpot) * sign(moment.v);
    }
    for (int b = 0; b < kBands; ++b) {
      const double off = (std::abs(moment.v) - bandSpeed(b)) / (kBand * bandSpeed(b));
      all(i, at++) = bell(off) * sign(moment.v);
    }
    for (int f = kFirstHum; f <= kLastHum; ++f) wave(0.2 * M_PI * f * t);
    for (int f = kFirstPulse; f <= kLastPulse; ++f) dry(0.2 * M_PI * f * t);
  }
  return all;
}

}  // namespace nao::validation
