#include "validation/diagnosis/signature.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace nao::validation {
namespace {

constexpr int kMost = 3;             // terms
constexpr double kWorth = 0.03;      // of the torque's power: less is no term
constexpr Eigen::Index kSmooth = 3;  // samples to each side, twice: derivatives of noise are noise
constexpr double kSlow = 0.05;       // [rad/s] below which the sign of v fades

Eigen::VectorXd smooth(const Eigen::VectorXd& x) {
  Eigen::VectorXd mean(x.size());
  for (Eigen::Index i = 0; i < x.size(); ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - kSmooth);
    const Eigen::Index to = std::min(x.size(), i + kSmooth + 1);
    mean[i] = x.segment(from, to - from).mean();
  }
  return mean;
}

Eigen::VectorXd slope(const Eigen::VectorXd& x, double dt) {
  Eigen::VectorXd rate = Eigen::VectorXd::Zero(x.size());
  for (Eigen::Index i = 1; i + 1 < x.size(); ++i) rate[i] = (x[i + 1] - x[i - 1]) / (2 * dt);
  return rate;
}

// An angle's change with its first two derivatives, of one motion.
Eigen::MatrixXd withRates(const Eigen::VectorXd& x, double dt) {
  Eigen::MatrixXd all(x.size(), 3);
  all.col(0) = smooth(smooth(x));
  all.col(1) = slope(all.col(0), dt);
  all.col(2) = slope(all.col(1), dt);
  return all;
}

// Of one motion: features by column.
struct Library {
  std::vector<std::string> names;             // of groups
  std::vector<std::vector<Eigen::Index>> of;  // a group's columns
  Eigen::Index columns = 0;
  void add(const std::string& name, Eigen::Index count) {
    names.push_back(name);
    of.emplace_back();
    for (Eigen::Index i = 0; i < count; ++i) of.back().push_back(columns++);
  }
};

constexpr int kFirstRipple = 3, kLastRipple = 40;  // periods in 2 pi of the joint
constexpr int kFirstHum = 5, kLastHum = 100;       // [0.1 Hz]

Library library() {
  Library all;
  for (const char* name : {"1", "sgn v", "v", "v|v|", "q", "a", "q sgn v", "t"}) all.add(name, 1);
  all.add("sin and cos of q", 2);
  char text[40];
  for (int n = kFirstRipple; n <= kLastRipple; ++n) {
    std::snprintf(text, sizeof text, "sin and cos of %d q", n);
    all.add(text, 2);
  }
  for (int f = kFirstHum; f <= kLastHum; ++f) {
    std::snprintf(text, sizeof text, "sin and cos of %.1f Hz", 0.1 * f);
    all.add(text, 2);
  }
  return all;
}

Eigen::MatrixXd features(const Eigen::MatrixXd& motion, double dt, Eigen::Index columns) {
  Eigen::MatrixXd all(motion.rows(), columns);
  for (Eigen::Index i = 0; i < motion.rows(); ++i) {
    const double q = motion(i, 0), v = motion(i, 1), t = dt * static_cast<double>(i);
    const double sign = std::tanh(v / kSlow);
    Eigen::Index at = 0;
    for (const double x : {1.0, sign, v, v * std::abs(v), q, motion(i, 2), q * sign, t}) {
      all(i, at++) = x;
    }
    const auto wave = [&](double angle) {
      all(i, at++) = std::sin(angle);
      all(i, at++) = std::cos(angle);
    };
    wave(q);
    for (int n = kFirstRipple; n <= kLastRipple; ++n) wave(n * q);
    for (int f = kFirstHum; f <= kLastHum; ++f) wave(0.2 * M_PI * f * t);
  }
  return all;
}

// The products that least squares on any of the features need, of one motion.
struct Products {
  Eigen::MatrixXd xx;
  Eigen::VectorXd xy;
  double yy = 0;
};

// What is left of left-out motions' power, with these columns fitted to the others.
double heldOut(const std::vector<Products>& motions, const std::vector<Eigen::Index>& columns) {
  const auto n = static_cast<Eigen::Index>(columns.size());
  const auto pick = [&](const Products& of, Eigen::MatrixXd& xx, Eigen::VectorXd& xy) {
    for (Eigen::Index i = 0; i < n; ++i) {
      xy[i] += of.xy[columns[static_cast<std::size_t>(i)]];
      for (Eigen::Index j = 0; j < n; ++j) {
        xx(i, j) +=
            of.xx(columns[static_cast<std::size_t>(i)], columns[static_cast<std::size_t>(j)]);
      }
    }
  };
  double left = 0;
  for (std::size_t out = 0; out < motions.size(); ++out) {
    Eigen::MatrixXd xx = Eigen::MatrixXd::Zero(n, n), own = xx;
    Eigen::VectorXd xy = Eigen::VectorXd::Zero(n), own_y = xy;
    for (std::size_t m = 0; m < motions.size(); ++m) {
      if (m != out) pick(motions[m], xx, xy);
    }
    pick(motions[out], own, own_y);
    xx.diagonal() *= 1 + 1e-9;  // columns may be all but the same
    const Eigen::VectorXd fit = xx.ldlt().solve(xy);
    left += motions[out].yy - 2 * fit.dot(own_y) + fit.dot(own * fit);
  }
  return left;
}

Signature select(const std::vector<Products>& motions, const Library& all) {
  Signature found;
  double power = 0;
  for (const Products& motion : motions) power += motion.yy;
  std::vector<Eigen::Index> columns;
  double left = power;
  while (static_cast<int>(found.terms.size()) < kMost && power > 0) {
    std::size_t best = all.of.size();
    double least = left - kWorth * power;
    for (std::size_t g = 0; g < all.of.size(); ++g) {
      std::vector<Eigen::Index> with = columns;
      with.insert(with.end(), all.of[g].begin(), all.of[g].end());
      const double now = heldOut(motions, with);
      if (now >= least) continue;
      least = now;
      best = g;
    }
    if (best == all.of.size()) break;
    columns.insert(columns.end(), all.of[best].begin(), all.of[best].end());
    found.terms.push_back({all.names[best], 1 - least / power});
    left = least;
  }
  return found;
}

// The factors of a change of angle, its rate and its second rate that make it the torque behind it:
// from looks at friction, whose torque is known.
Eigen::VectorXd torqueFactors(const JointData& data, const Stage& stage,
                              const std::vector<Cause>& causes) {
  Eigen::MatrixXd xx = Eigen::MatrixXd::Zero(3, 3);
  Eigen::VectorXd xy = Eigen::VectorXd::Zero(3);
  for (const Look& look : stage.looks()) {
    const std::string& effect = causes[look.cause].effect;
    if (effect != "viscous_friction" && effect != "torque_bias") continue;
    for (const MotionSpan& span : data.spans()) {
      if (span.split != Split::Fit) continue;
      const Eigen::MatrixXd motion =
          withRates(data.mean().segment(span.offset, span.rows), span.dt);
      const Eigen::MatrixXd change =
          withRates(look.raw.mean().segment(span.offset, span.rows), span.dt);
      const Eigen::VectorXd torque = effect == "torque_bias"
                                         ? Eigen::VectorXd::Constant(span.rows, look.x[0])
                                         : Eigen::VectorXd(-look.x[0] * motion.col(1));
      const double weight = 1 / std::max(torque.squaredNorm(), 1e-12);
      xx += weight * change.transpose() * change;
      xy += weight * change.transpose() * torque;
    }
  }
  return xx.ldlt().solve(xy);
}

}  // namespace

std::string Signature::text() const {
  std::string all;
  for (const SignatureTerm& term : terms) {
    char part[80];
    std::snprintf(part, sizeof part, "%s%s (%.0f %%)", all.empty() ? "" : ", then ",
                  term.feature.c_str(), 100 * term.explained);
    all += part;
  }
  return all;
}

Signature signatureOf(const JointData& data, const Stage& stage, const std::vector<Cause>& causes) {
  const Eigen::VectorXd factors = torqueFactors(data, stage, causes);
  const Library all = library();
  std::vector<Products> motions;
  for (const MotionSpan& span : data.spans()) {
    if (span.split != Split::Fit) continue;
    const Eigen::MatrixXd motion = withRates(data.mean().segment(span.offset, span.rows), span.dt);
    const Eigen::MatrixXd x = features(motion, span.dt, all.columns);
    const Eigen::VectorXd torque =
        withRates(stage.raw().segment(span.offset, span.rows), span.dt) * factors;
    motions.push_back({x.transpose() * x, x.transpose() * torque, torque.squaredNorm()});
  }
  if (motions.size() < 2) return {};
  return select(motions, all);
}

}  // namespace nao::validation
