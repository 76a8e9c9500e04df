#include "validation/diagnosis/candidate_fit.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>

#include "validation/diagnosis/least_squares.h"

namespace nao::validation {
namespace {

constexpr double kNearlyAsGood = 0.7;  // of the best start's gain: free choice

// Finite differences as wide as the size of interest: less matters to nobody.
double stepOf(const FreeNumber& number) {
  const double typical = number.starts.empty() ? 1e-3 : std::abs(number.starts.front());
  return number.smallest > 0 ? number.smallest : std::max(0.05 * typical, 1e-6);
}

void append(FitSpace& space, const Cause& cause, const std::vector<double>& x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    space.start.push_back(x[i]);
    space.lower.push_back(cause.free[i].lower);
    space.upper.push_back(cause.free[i].upper);
    space.step.push_back(stepOf(cause.free[i]));
  }
}

// Rough causes have several valleys: the size that fits best of a widely, then a finely spaced row.
std::vector<double> scanned(
    const std::function<Eigen::VectorXd(const std::vector<double>&)>& residual,
    const FitSpace& space) {
  std::vector<double> best = space.start;
  double least = residual(best).squaredNorm();
  for (const std::vector<double>& row :
       {std::vector<double>{0.4, 0.63, 1.6, 2.5}, {0.8, 1.25}, {0.9, 1.11}}) {
    const std::vector<double> centre = best;
    for (const double factor : row) {
      std::vector<double> x = centre;
      x[0] = std::clamp(x[0] * factor, space.lower[0], space.upper[0]);
      const double cost = residual(x).squaredNorm();
      if (cost >= least) continue;
      least = cost;
      best = x;
    }
  }
  return best;
}

CauseList withNumbers(CauseList model, const std::vector<double>& numbers) {
  std::size_t next = 0;
  for (Chosen& one : model) {
    for (double& x : one.x) x = numbers[next++];
  }
  return model;
}

}  // namespace

QuickFit fitQuickly(Ensemble& ensemble, const JointData& data, const Stage& stage,
                    const std::vector<Cause>& causes, std::size_t cause,
                    const std::vector<double>& x, const Eigen::VectorXd& raw, const CauseList& rest,
                    const Effort& effort) {
  (void)data;
  FitSpace space;
  append(space, causes[cause], x);
  space.iterations = 4;
  const Eigen::VectorXd before = stage.white(raw);
  const Eigen::VectorXd base = rest.size() == stage.model().size()
                                   ? stage.lookBase()
                                   : ensemble.mean(settingsOf(causes, rest), effort.look_runs);
  const auto residual = [&](const std::vector<double>& numbers) -> Eigen::VectorXd {
    CauseList with = rest;
    with.push_back({cause, numbers});
    const Eigen::VectorXd mean = ensemble.mean(settingsOf(causes, with), effort.look_runs);
    return stage.white(raw - (mean - base));
  };
  // What was scanned is in its valley; others have to find theirs.
  const std::vector<double>& seen = causes[cause].scan;
  const bool found = std::find(seen.begin(), seen.end(), x[0]) != seen.end();
  if (!causes[cause].linear && !found) {
    space.start = scanned(residual, space);
    const double gain = (before.squaredNorm() - residual(space.start).squaredNorm()) / 2;
    if (gain <= 0) return {cause, space.start, gain};  // no size helps: no slope will
  }
  const FitPoint best = leastSquares(residual, space);
  return {cause, best.x, before.squaredNorm() / 2 - best.cost};
}

ModelFit fitFully(Ensemble& ensemble, const JointData& data, const Stage& stage,
                  const std::vector<Cause>& causes, const CauseList& start, const Effort& effort) {
  FitSpace space;
  for (const Chosen& one : start) append(space, causes[one.cause], one.x);
  const Eigen::VectorXd base = ensemble.mean(settingsOf(causes, stage.model()), effort.final_runs);
  const auto rawAt = [&](const std::vector<double>& numbers) -> Eigen::VectorXd {
    const CauseList model = withNumbers(start, numbers);
    return stage.raw() - (ensemble.mean(settingsOf(causes, model), effort.final_runs) - base);
  };
  std::vector<std::pair<std::vector<double>, Eigen::VectorXd>> seen;
  const FitPoint best = leastSquares(
      [&](const std::vector<double>& numbers) -> Eigen::VectorXd {
        seen.emplace_back(numbers, rawAt(numbers));
        return stage.whitenFit(seen.back().second);
      },
      space);
  ModelFit fit;
  fit.model = withNumbers(start, best.x);
  fit.white = best.residual;
  fit.gain = stage.whitenFit(stage.raw()).squaredNorm() / 2 - best.cost;
  const auto rawOf = [&](const std::vector<double>& x) {
    const auto found =
        std::find_if(seen.rbegin(), seen.rend(), [&](const auto& one) { return one.first == x; });
    return found != seen.rend() ? found->second : rawAt(x);
  };
  fit.raw = rawOf(best.x);
  fit.jacobian.resize(data.size(), static_cast<Eigen::Index>(best.x.size()));
  for (std::size_t i = 0; i < best.x.size(); ++i) {  // as least_squares.cc took them: all are seen
    std::vector<double> beside = best.x;
    const double step = differenceStep(space, i, best.x[i]);
    beside[i] += step;
    fit.jacobian.col(static_cast<Eigen::Index>(i)) =
        (fit.raw - rawOf(beside)) / (beside[i] - best.x[i]);
  }
  return fit;
}

void moveNumbers(ModelFit& fit, const Eigen::VectorXd& raw, const Stage& stage,
                 const std::vector<Cause>& causes) {
  const Eigen::VectorXd left = stage.whitenFit(raw);
  Eigen::MatrixXd white(left.size(), fit.jacobian.cols());
  for (Eigen::Index i = 0; i < white.cols(); ++i) {
    white.col(i) = stage.whitenFit(fit.jacobian.col(i));
  }
  const Eigen::VectorXd move = white.colPivHouseholderQr().solve(left);
  fit.raw = raw;
  Eigen::Index column = 0;
  for (Chosen& one : fit.model) {
    for (std::size_t i = 0; i < one.x.size(); ++i, ++column) {
      const FreeNumber& number = causes[one.cause].free[i];
      const bool rough = i == 0 && !causes[one.cause].scan.empty();  // its slope leads nowhere
      const double wanted = rough ? one.x[i] : one.x[i] + move[column];
      const double x = std::clamp(wanted, number.lower, number.upper);
      fit.raw -= (x - one.x[i]) * fit.jacobian.col(column);
      one.x[i] = x;
    }
  }
}

std::vector<QuickFit> startsFor(const Stage& stage, const std::vector<Cause>& causes,
                                const Eigen::VectorXd& white, double least, int most) {
  std::vector<QuickFit> starts;
  for (const Look& look : stage.looks()) {
    double scale = 0;
    const double gain = Stage::gain(look, white, &scale);
    if (gain < least || scale == 0) continue;
    QuickFit start{look.cause, look.x, gain};
    // A rough cause is what it was seen to be, if that helped at all; its sizes are scanned later.
    const double as_seen = look.white.dot(white) - look.white.squaredNorm() / 2;
    if (causes[look.cause].linear || as_seen <= 0) start.x[0] *= scale;
    starts.push_back(std::move(start));
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const QuickFit& a, const QuickFit& b) { return a.gain > b.gain; });
  std::vector<QuickFit> kept;
  std::vector<std::size_t> known;
  for (const QuickFit& start : starts) {
    int same = 0;
    double best = 0;
    for (const QuickFit& other : kept) {
      if (other.cause == start.cause) ++same, best = std::max(best, other.gain);
    }
    if (same >= 2 || (same == 1 && start.gain < kNearlyAsGood * best)) continue;
    if (same == 0 && static_cast<int>(known.size()) >= most) continue;
    if (same == 0) known.push_back(start.cause);
    kept.push_back(start);
  }
  return kept;
}

}  // namespace nao::validation
