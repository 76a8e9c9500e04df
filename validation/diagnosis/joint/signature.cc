#include "validation/diagnosis/joint/signature.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "validation/diagnosis/joint/torque_features.h"
#include "validation/diagnosis/maths/lag.h"
#include "validation/diagnosis/rig/led_joint.h"

namespace nao::validation {
namespace {

constexpr int kMost = 3;              // terms
constexpr double kWorth = 0.03;       // of what remains: less per column is no term
constexpr std::size_t kNulls = 40;    // sets that tell what noise lacks
constexpr double kMisread = 0.05;     // [rad] as far off as encoders are that are worth a word
constexpr double kNearStop = 0.15;    // [rad] of the range's end: an encoder may be off by that
constexpr double kAtRest = 0.05;      // [rad/s]
constexpr double kBeyondNulls = 1.5;  // times the most that a feature explains of one of them

using Columns = std::vector<Eigen::Index>;

// Of one motion: its features, and the products that least squares on any of them need.
struct Along {
  Eigen::MatrixXd x, xx;
};

// What remains of every motion.
class Remainder {
 public:
  /// `torque` of one motion, as its features by the SD of noise.
  void add(const std::shared_ptr<const Along>& along, const Eigen::VectorXd& torque) {
    motions_.push_back({along, along->x.transpose() * torque});
    excess_ += torque.squaredNorm() - static_cast<double>(torque.size());
  }
  double excess() const { return excess_; }  // squares that noise does not account for
  std::size_t motions() const { return motions_.size(); }
  double explained(const Columns& columns) const;

 private:
  struct Motion {
    std::shared_ptr<const Along> along;
    Eigen::VectorXd xy;
  };
  std::vector<Motion> motions_;
  double excess_ = 0;
};

// What these columns explain of left-out motions' squares, fitted to the others.
double Remainder::explained(const Columns& columns) const {
  const auto n = static_cast<Eigen::Index>(columns.size());
  Eigen::MatrixXd whole_xx = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd whole_xy = Eigen::VectorXd::Zero(n);
  for (const Motion& motion : motions_) {
    whole_xx += motion.along->xx(columns, columns);
    whole_xy += motion.xy(columns);
  }
  double explained = 0;
  for (const Motion& out : motions_) {
    const Eigen::MatrixXd own = out.along->xx(columns, columns);
    const Eigen::VectorXd own_y = out.xy(columns);
    Eigen::MatrixXd xx = whole_xx - own;
    xx.diagonal() *= 1 + 1e-9;  // columns may be all but the same
    const Eigen::VectorXd fit = xx.ldlt().solve(whole_xy - own_y);
    explained += 2 * fit.dot(own_y) - fit.dot(own * fit);
  }
  return std::isfinite(explained) ? explained : 0;
}

// Never nothing: it divides.
double rootMeanSquare(const Eigen::MatrixXd& x) {
  return std::sqrt(
      std::max(x.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, x.size())), 1e-18));
}

// The torques that a model lacks, of one motion, when they act: what is told of a joint is late.
class Lack {
 public:
  Lack(const JointSimulator& joint, const Stage& stage, const std::vector<EffectSetting>& causes,
       const MotionSpan& span)
      : joint_(joint),
        causes_(causes),
        span_(span),
        nothing_(Eigen::VectorXd::Zero(span.rows)),
        alone_(joint.led(causes_, span.motion, nothing_, nothing_)) {
    if (isKnown()) late_ = rowsLate(stage.predicted().segment(span.offset, span.rows), course());
  }

  bool isKnown() const { return alone_.torque.size() > 0; }
  /// Of all motions: this one's, when it was so.
  Eigen::VectorXd then(const Eigen::VectorXd& told) const {
    return earlier(told.segment(span_.offset, span_.rows), late_);
  }
  /// Where this is added to the prediction.
  Eigen::VectorXd by(const Eigen::VectorXd& residual) const {
    return joint_.led(causes_, span_.motion, then(residual), nothing_).torque;
  }
  /// Where readings, on the predicted course, are `misread` too much, per unit of that.
  Eigen::VectorXd byMisreading(const Eigen::VectorXd& shape) const {
    const Eigen::VectorXd misread = kMisread * shape;
    return -joint_.led(causes_, span_.motion, -misread, misread).torque / kMisread;
  }
  const Eigen::VectorXd& course() const { return alone_.angle; }
  /// What the servo is off by along the predicted course: along the measured one every torque that
  /// is not known shows in it.
  const Eigen::VectorXd& error() const { return alone_.error; }
  double dt() const { return span_.dt; }
  std::pair<double, double> range() const { return joint_.range(); }

 private:
  const JointSimulator& joint_;
  std::vector<EffectSetting> causes_;
  MotionSpan span_;
  Eigen::VectorXd nothing_;
  LedRun alone_;
  double late_ = 0;  // rows
};

// What the measurement and what null sets leave.
struct Remainders {
  Remainder measured;
  std::vector<Remainder> nulls;
};

void addMotion(const Lack& lack, const Stage& stage, const TorqueFeatures& features,
               const Eigen::MatrixXd& motion, Remainders& all) {
  const std::vector<Eigen::Index> rows = rowsOffStops(motion, lack.range());
  Eigen::MatrixXd chance(rows.size(), all.nulls.size());
  for (Eigen::Index i = 0; i < chance.cols(); ++i) {
    chance.col(i) = lack.by(stage.nulls()[static_cast<std::size_t>(i)])(rows);
  }
  const double sd = rootMeanSquare(chance);
  auto along = std::make_shared<Along>();
  along->x = features.along(motion, lack.error(), lack.dt());
  for (Eigen::Index i = 0; i < features.misreadings(); ++i) {
    along->x.col(features.columns() - features.misreadings() + i) =
        lack.byMisreading(features.misreading(i, lack.course()));
  }
  along->x = (along->x(rows, Eigen::all) / sd).eval();
  along->xx = along->x.transpose() * along->x;
  all.measured.add(along, lack.by(stage.raw())(rows) / sd);
  for (Eigen::Index i = 0; i < chance.cols(); ++i) {
    all.nulls[static_cast<std::size_t>(i)].add(along, chance.col(i) / sd);
  }
}

// The most that one feature explains.
double mostOf(const Remainder& remainder, const std::vector<TorqueFeatures::Feature>& features) {
  double most = 0;
  for (const TorqueFeatures::Feature& one : features) {
    most = std::max(most, remainder.explained(one.columns));
  }
  return most;
}

// `chance`: the most that a feature explains of null sets.
Signature select(const Remainder& remainder, double chance,
                 const std::vector<TorqueFeatures::Feature>& features) {
  Signature found;
  Columns columns;
  double before = 0;
  const auto cost = [&](const TorqueFeatures::Feature& one) {
    const auto count = static_cast<double>(one.columns.size());
    return std::max(count * kWorth * remainder.excess(), kBeyondNulls * chance);
  };
  while (static_cast<int>(found.terms.size()) < kMost && remainder.excess() > 0) {
    const TorqueFeatures::Feature* best = nullptr;
    double most = before, merit = before;  // what is explained, and less what its columns cost
    for (const TorqueFeatures::Feature& one : features) {
      Columns with = columns;
      with.insert(with.end(), one.columns.begin(), one.columns.end());
      const double now = remainder.explained(with);
      const double worth = now - cost(one);
      if (worth <= merit) continue;
      most = now;
      merit = worth;
      best = &one;
    }
    if (best == nullptr) break;
    columns.insert(columns.end(), best->columns.begin(), best->columns.end());
    found.terms.push_back({best->name, std::min(1.0, most / remainder.excess())});
    before = most;
  }
  return found;
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

std::vector<Eigen::Index> rowsOffStops(const Eigen::MatrixXd& motion,
                                       std::pair<double, double> range) {
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < motion.rows(); ++i) {
    const double q = motion(i, 0);
    const bool near = q < range.first + kNearStop || q > range.second - kNearStop;
    if (!near || std::abs(motion(i, 1)) > kAtRest) rows.push_back(i);
  }
  return rows;
}

Signature signatureOf(const JointSimulator& joint, const JointData& data, const Stage& stage,
                      const std::vector<EffectSetting>& causes) {
  const TorqueFeatures features;
  Remainders all;
  all.nulls.resize(std::min(kNulls, stage.nulls().size()));
  for (const MotionSpan& span : data.spans()) {
    if (span.split != Split::Fit) continue;
    const Lack lack(joint, stage, causes, span);
    if (!lack.isKnown()) return {};
    addMotion(lack, stage, features, withRates(lack.then(data.mean()), span.dt), all);
  }
  if (all.measured.motions() < 2) return {};
  double chance = 0;
  for (const Remainder& null : all.nulls) chance = std::max(chance, mostOf(null, features.all()));
  return select(all.measured, chance, features.all());
}

}  // namespace nao::validation
