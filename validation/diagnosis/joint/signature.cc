#include "validation/diagnosis/joint/signature.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>

#include "validation/diagnosis/joint/torque_features.h"
#include "validation/diagnosis/maths/lag.h"
#include "validation/diagnosis/maths/thin_svd.h"
#include "validation/diagnosis/maths/whitening.h"
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

// Of several motions.
struct Products {
  Eigen::MatrixXd xx;
  Eigen::VectorXd xy;

  Eigen::VectorXd fit() const {
    Eigen::MatrixXd more = xx;
    more.diagonal() *= 1 + 1e-9;  // columns may be all but the same
    return more.ldlt().solve(xy);
  }
};

// What remains of every motion.
class Remainder {
 public:
  /// `torque` of one motion, as its features by the SD of noise.
  void add(const std::shared_ptr<const Along>& along, const Eigen::VectorXd& torque) {
    motions_.push_back({along, along->x.transpose() * torque});
    excess_ += torque.squaredNorm() - static_cast<double>(torque.size());
  }
  // Squares that noise does not account for.
  double excess() const { return excess_; }
  std::size_t motions() const { return motions_.size(); }
  // What these columns explain of left-out motions' squares, fitted to the others.
  double explained(const Columns& columns) const;
  // The same of no motion that is left out: more, the more columns there are.
  double fitted(const Columns& columns) const;
  // What these columns' factors are.
  Eigen::VectorXd fit(const Columns& columns) const { return products(columns).fit(); }

 private:
  Products products(const Columns& columns) const;

  struct Motion {
    std::shared_ptr<const Along> along;
    Eigen::VectorXd xy;
  };
  std::vector<Motion> motions_;
  double excess_ = 0;
};

Products Remainder::products(const Columns& columns) const {
  const auto n = static_cast<Eigen::Index>(columns.size());
  Products all{Eigen::MatrixXd::Zero(n, n), Eigen::VectorXd::Zero(n)};
  for (const Motion& motion : motions_) {
    all.xx += motion.along->xx(columns, columns);
    all.xy += motion.xy(columns);
  }
  return all;
}

double Remainder::explained(const Columns& columns) const {
  const Products all = products(columns);
  double explained = 0;
  for (const Motion& out : motions_) {
    const Eigen::MatrixXd own = out.along->xx(columns, columns);
    const Eigen::VectorXd own_y = out.xy(columns);
    const Eigen::VectorXd fit = Products{all.xx - own, all.xy - own_y}.fit();
    explained += 2 * fit.dot(own_y) - fit.dot(own * fit);
  }
  return std::isfinite(explained) ? explained : 0;
}

double Remainder::fitted(const Columns& columns) const {
  const Products all = products(columns);
  const double explained = all.fit().dot(all.xy);
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
  explicit Remainders(std::size_t of_nulls) : nulls(of_nulls) {}

  Remainder measured;
  std::vector<Remainder> nulls;
};

// Of null sets every other one tells what noise is like; the rest are judged by that as the
// measurement is.
Eigen::MatrixXd lackOf(const Lack& lack, const Stage& stage, const Columns& rows, std::size_t first,
                       std::size_t nulls) {
  Eigen::MatrixXd torque(rows.size(), nulls);
  for (std::size_t i = 0; i < nulls; ++i) {
    torque.col(static_cast<Eigen::Index>(i)) = lack.by(stage.nulls()[first + 2 * i])(rows);
  }
  return torque;
}

// The direction in which null sets differ most. By more of them an eccentric encoder was lost: what
// is left to count is mostly where the torque of a remainder is not exact.
Eigen::MatrixXd mostOf(const Eigen::MatrixXd& noise) {
  if (noise.size() == 0) return noise;
  const ThinSvd parts = calcSvd(noise);
  return parts.left.leftCols(1) * parts.values[0];
}

void addMotion(const Lack& lack, const Stage& stage, const TorqueFeatures& features,
               const Eigen::MatrixXd& motion, Remainders& all) {
  const Columns rows = rowsOffStops(motion, lack.range());
  const std::size_t nulls = all.nulls.size();
  const Eigen::MatrixXd noise = lackOf(lack, stage, rows, 0, nulls);
  const Whitening whiten(Eigen::VectorXd::Constant(noise.rows(), rootMeanSquare(noise)),
                         mostOf(noise / std::sqrt(std::max<std::size_t>(1, nulls))));
  auto along = std::make_shared<Along>();
  along->x = features.along(motion, lack.error(), lack.dt());
  for (Eigen::Index i = 0; i < features.misreadings(); ++i) {
    along->x.col(features.columns() - features.misreadings() + i) =
        lack.byMisreading(features.misreading(i, lack.course()));
  }
  along->x = along->x(rows, Eigen::all).eval();
  for (Eigen::Index i = 0; i < along->x.cols(); ++i) along->x.col(i) = whiten(along->x.col(i));
  along->xx = along->x.transpose() * along->x;
  all.measured.add(along, whiten(lack.by(stage.raw())(rows)));
  const Eigen::MatrixXd chance = lackOf(lack, stage, rows, 1, nulls);
  for (std::size_t i = 0; i < nulls; ++i) {
    all.nulls[i].add(along, whiten(chance.col(static_cast<Eigen::Index>(i))));
  }
}

// What each feature must explain to be told from chance: as many times what it explains of null
// sets, root mean square, as any feature does of any of these. Equal robots differ by friction,
// which goes with the sign of v and hardly with its square.
Eigen::VectorXd beyondChance(const std::vector<Remainder>& nulls,
                             const std::vector<TorqueFeatures::Feature>& features) {
  if (nulls.empty()) return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(features.size()));
  Eigen::MatrixXd explained(features.size(), nulls.size());
  for (Eigen::Index i = 0; i < explained.rows(); ++i) {
    for (Eigen::Index j = 0; j < explained.cols(); ++j) {
      const Columns& columns = features[static_cast<std::size_t>(i)].columns;
      explained(i, j) = nulls[static_cast<std::size_t>(j)].fitted(columns);
    }
  }
  const Eigen::VectorXd usual = explained.rowwise().norm() / std::sqrt(explained.cols());
  const Eigen::VectorXd known = usual.cwiseMax(std::max(1e-6 * usual.maxCoeff(), 1e-18));
  return kBeyondNulls * (known.cwiseInverse().asDiagonal() * explained).maxCoeff() * known;
}

Ripple rippleOf(const Remainder& remainder, const Columns& columns,
                const TorqueFeatures::Feature& feature) {
  const auto sine = std::find(columns.begin(), columns.end(), feature.columns[0]);
  const Eigen::Index place = sine - columns.begin();
  const Eigen::VectorXd factors = remainder.fit(columns);
  const double a = factors[place], b = factors[place + 1];
  return {std::hypot(a, b), feature.periods, std::atan2(b, a)};
}

Signature select(const Remainders& all, const std::vector<TorqueFeatures::Feature>& features) {
  const Remainder& remainder = all.measured;
  const double excess = remainder.excess();
  const Eigen::VectorXd least = beyondChance(all.nulls, features);
  Signature found;
  Columns columns;
  const TorqueFeatures::Feature* ripple = nullptr;
  double before = 0;
  while (static_cast<int>(found.terms.size()) < kMost && excess > 0) {
    const TorqueFeatures::Feature* best = nullptr;
    double most = before, merit = before;  // what is explained, and less what its columns cost
    for (std::size_t i = 0; i < features.size(); ++i) {
      const TorqueFeatures::Feature& one = features[i];
      Columns with = columns;
      with.insert(with.end(), one.columns.begin(), one.columns.end());
      const double now = remainder.explained(with);
      const auto count = static_cast<double>(one.columns.size());
      const double worth = now - count * kWorth * excess;
      if (worth <= merit || now - before <= least[static_cast<Eigen::Index>(i)]) continue;
      most = now;
      merit = worth;
      best = &one;
    }
    if (best == nullptr) break;
    if (found.terms.empty() && best->periods > 0) ripple = best;
    columns.insert(columns.end(), best->columns.begin(), best->columns.end());
    found.terms.push_back({best->name, most});
    before = most;
  }
  if (ripple != nullptr) found.ripple = rippleOf(remainder, columns, *ripple);
  const double whole = std::max(before, excess);  // noise may be less than it is given
  for (SignatureTerm& term : found.terms) term.explained /= whole;
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
  Remainders all(std::min(kNulls, stage.nulls().size() / 2));
  for (const MotionSpan& span : data.spans()) {
    if (span.split != Split::Fit) continue;
    const Lack lack(joint, stage, causes, span);
    if (!lack.isKnown()) return {};
    addMotion(lack, stage, features, withRates(lack.then(data.mean()), span.dt), all);
  }
  if (all.measured.motions() < 2) return {};
  return select(all, features.all());
}

Signature lackedAt(const JointSimulator& joint, const Ensemble& ensemble,
                   const std::vector<Cause>& causes, const Stage& stage) {
  std::vector<EffectSetting> model = ensemble.given();
  for (const EffectSetting& one : settingsOf(causes, stage.model())) model.push_back(one);
  return signatureOf(joint, ensemble.data(), stage, model);
}

}  // namespace nao::validation
