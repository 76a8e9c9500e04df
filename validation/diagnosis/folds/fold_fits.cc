#include "validation/diagnosis/folds/fold_fits.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <numeric>

#include "core/check.h"
#include "validation/diagnosis/jobs/team.h"

namespace nao::validation {
namespace {

constexpr std::size_t kHeldOut = 4;  // causes that are fitted without each fold

std::string gainName(double kp_scale) {
  char text[32];
  std::snprintf(text, sizeof text, "gain x %g", kp_scale);
  return text;
}

// Rough causes have several valleys.
std::size_t startsFor(const Cause& cause) { return cause.linear ? 1 : 2; }

// Of y beside all columns but the last.
double weightedRest(const Eigen::MatrixXd& columns, const Eigen::VectorXd& y) {
  const Eigen::MatrixXd own = columns.leftCols(columns.cols() - 1);
  return (y - own * own.colPivHouseholderQr().solve(y)).squaredNorm();
}

std::vector<Cause> boundedAll(std::vector<Cause> causes, const JointSimulator& joint) {
  for (Cause& cause : causes) cause = boundedAt(cause, joint, sim::standardEffects());
  return causes;
}

}  // namespace

double FoldErrors::mean() const {
  return std::accumulate(held_out.begin(), held_out.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(1, held_out.size()));
}

std::vector<Fold> foldsOf(const JointSimulator& joint, const std::vector<double>& gains) {
  std::map<double, std::vector<std::size_t>> by_gain;
  std::vector<Fold> motions;
  for (std::size_t m = 0; m < joint.measured().size(); ++m) {
    const JointMotion& motion = joint.measured()[m];
    if (motion.split == Split::Test) continue;
    by_gain[m < gains.size() ? gains[m] : 1].push_back(m);
    motions.push_back({motion.motion, {m}});
  }
  std::vector<Fold> folds;
  for (auto& [gain, list] : by_gain) folds.push_back({gainName(gain), std::move(list)});
  if (folds.size() < 2) folds = std::move(motions);
  if (folds.size() < 2) {
    throw InputError(joint.joint() + ": expected motions of two gains, or two motions");
  }
  return folds;
}

FoldFits::FoldFits(const JointSimulator& joint, const std::vector<Cause>& causes,
                   std::vector<Fold> folds, const MotionFitOptions& options, int jobs)
    : folds_(std::move(folds)),
      causes_(boundedAll(causes, joint)),
      jobs_(jobs),
      fit_(joint, noise_, causes_, options) {
  for (const Fold& fold : folds_) all_.insert(all_.end(), fold.motions.begin(), fold.motions.end());
  std::sort(all_.begin(), all_.end());
}

FoldModel FoldFits::empty() const {
  FoldModel model;
  model.of_fold.assign(folds_.size(), {});
  measure(model);
  return model;
}

std::vector<std::size_t> FoldFits::motionsWithout(std::size_t fold) const {
  std::vector<std::size_t> rest;
  for (std::size_t f = 0; f < folds_.size(); ++f) {
    if (f == fold) continue;
    rest.insert(rest.end(), folds_[f].motions.begin(), folds_[f].motions.end());
  }
  std::sort(rest.begin(), rest.end());
  return rest;
}

void FoldFits::measure(FoldModel& model) const {
  model.errors.held_out.clear();
  for (std::size_t f = 0; f < folds_.size(); ++f) {
    model.errors.held_out.push_back(fit_.meanError(model.of_fold[f], folds_[f].motions));
  }
}

// The best fit from any of these starts of a further cause.
MotionFit::Result FoldFits::bestOf(const CauseList& model, const FoldCandidate& candidate,
                                   const std::vector<std::size_t>& motions) const {
  MotionFit::Result best;
  for (const std::vector<double>& x : candidate.starts) {
    CauseList with = model;
    with.push_back({candidate.cause, x});
    MotionFit::Result result = fit_.fit(with, motions);
    if (best.model.empty() || result.cost < best.cost) best = std::move(result);
  }
  return best;
}

// What one look at a start explains of the weighted residual beside the model's own numbers.
FoldFits::Looked FoldFits::lookAt(const MotionFit::Result& at, std::size_t cause,
                                  std::vector<double> x) const {
  CauseList with = at.model;
  with.push_back({cause, x});
  const Eigen::VectorXd root = fit_.weights(at.residual).cwiseSqrt();
  Eigen::MatrixXd columns(at.residual.size(), at.jacobian.cols() + 1);
  columns.leftCols(at.jacobian.cols()) = root.asDiagonal() * at.jacobian;
  columns.rightCols(1) = root.cwiseProduct(at.residual - fit_.residual(with, all_));
  const Eigen::VectorXd y = root.cwiseProduct(at.residual);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  const Eigen::VectorXd scales = qr.solve(y);
  const double scale = scales[scales.size() - 1];
  const FreeNumber& size = causes_[cause].free[0];
  const bool any = causes_[cause].linear;
  const double used = any ? scale : std::clamp(scale, 0.0, kFurthest);
  if (any) x[0] = std::clamp(used * x[0], size.lower, size.upper);
  const Eigen::VectorXd own = columns.leftCols(at.jacobian.cols()) * scales.head(scales.size() - 1);
  const double before = at.jacobian.cols() > 0 ? weightedRest(columns, y) : y.squaredNorm();
  return {x, before - (y - own - used * columns.rightCols(1)).squaredNorm()};
}

// The causes that promise most by one look each, best first, each with its best starts.
std::vector<FoldCandidate> FoldFits::screened(const FoldModel& model, int most) const {
  MotionFit::Result at;
  at.model = model.of_all;
  fit_.linearise(at, all_);
  std::vector<std::vector<Looked>> looks(causes_.size());
  inParallel(causes_.size(), jobs_, [&](std::size_t c) {
    if (has(model.of_all, c)) return;
    for (const auto& x : startsOf(causes_[c])) looks[c].push_back(lookAt(at, c, x));
    std::stable_sort(looks[c].begin(), looks[c].end(),
                     [](const Looked& a, const Looked& b) { return a.gain > b.gain; });
  });
  std::vector<std::size_t> order;
  for (std::size_t c = 0; c < causes_.size(); ++c) {
    if (!looks[c].empty() && looks[c].front().gain > 0) order.push_back(c);
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return looks[a].front().gain > looks[b].front().gain;
  });
  std::vector<FoldCandidate> best;
  for (const std::size_t c : order) {
    if (static_cast<int>(best.size()) >= most) break;
    FoldCandidate candidate{c, {}};
    for (std::size_t i = 0; i < looks[c].size() && i < startsFor(causes_[c]); ++i) {
      candidate.starts.push_back(looks[c][i].x);
    }
    best.push_back(std::move(candidate));
  }
  return best;
}

std::vector<FoldTried> FoldFits::tryAll(const FoldModel& model,
                                        const std::vector<FoldCandidate>& candidates) const {
  std::vector<FoldTried> tried(candidates.size());
  inParallel(candidates.size(), jobs_, [&](std::size_t i) {
    MotionFit::Result all = bestOf(model.of_all, candidates[i], all_);
    tried[i] = {candidates[i].cause, i, all.cost, {}};
    tried[i].model.of_all = std::move(all.model);
    tried[i].model.of_fold.resize(folds_.size());
  });
  std::stable_sort(tried.begin(), tried.end(),
                   [](const FoldTried& a, const FoldTried& b) { return a.cost < b.cost; });
  tried.resize(std::min(tried.size(), kHeldOut));
  inParallel(tried.size() * folds_.size(), jobs_, [&](std::size_t task) {
    FoldTried& one = tried[task / folds_.size()];
    const std::size_t f = task % folds_.size();
    one.model.of_fold[f] = bestOf(model.of_fold[f], candidates[one.place], motionsWithout(f)).model;
  });
  for (FoldTried& one : tried) measure(one.model);
  std::stable_sort(tried.begin(), tried.end(), [](const FoldTried& a, const FoldTried& b) {
    return a.model.errors.mean() < b.model.errors.mean();
  });
  return tried;
}

std::vector<FoldModel> FoldFits::withoutEach(const FoldModel& model) const {
  std::vector<FoldModel> without(model.of_all.size());
  const std::size_t parts = folds_.size() + 1;
  for (FoldModel& one : without) one.of_fold.resize(folds_.size());
  inParallel(without.size() * parts, jobs_, [&](std::size_t task) {
    const std::size_t i = task / parts, f = task % parts;
    const bool all = f == folds_.size();
    CauseList rest = all ? model.of_all : model.of_fold[f];
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    CauseList& place = all ? without[i].of_all : without[i].of_fold[f];
    place = fit_.fit(rest, all ? all_ : motionsWithout(f)).model;
  });
  for (FoldModel& one : without) measure(one);
  return without;
}

}  // namespace nao::validation
