#include "validation/diagnosis/joint/candidate_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "validation/diagnosis/joint/size_search.h"
#include "validation/diagnosis/maths/least_squares.h"

namespace nao::validation {
namespace {

constexpr double kNearlyAsGood = 0.7;  // of the best start's gain: free choice
// Of a size: what another look makes of it; beyond, its cause is not linear that far. Free choice.
constexpr double kAlike = 0.5;
constexpr double kKept = 0.5;     // of what is promised: less, and it misleads
constexpr double kAsTried = 0.8;  // of what the size itself was seen to gain

// Finite differences as wide as the size of interest: less matters to nobody.
double stepOf(const FreeNumber& number) {
  const double typical = number.starts.empty() ? 1e-3 : std::abs(number.starts.front());
  return number.smallest > 0 ? number.smallest : std::max(0.05 * typical, 1e-6);
}

void append(FitSpace& space, const Cause& cause, const std::vector<double>& x) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    space.start.push_back(x[i]);
    const bool fixed = i == 0 && cause.beats;  // the response to the next size is another
    space.lower.push_back(fixed ? x[i] : cause.free[i].lower);
    space.upper.push_back(fixed ? x[i] : cause.free[i].upper);
    space.step.push_back(stepOf(cause.free[i]));
  }
}

// What a model's numbers change of the prediction, by ensembles of final_runs; remembers.
class ModelChanges {
 public:
  ModelChanges(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
               const CauseList& start, const Effort& effort)
      : ensemble_(ensemble),
        stage_(stage),
        causes_(causes),
        start_(start),
        effort_(effort),
        base_(ensemble.halves(settingsOf(causes, stage.model()), effort.final_runs)) {}

  const Halves& at(const std::vector<double>& numbers) {
    const auto known = seen_.find(numbers);
    if (known != seen_.end()) return known->second;
    const auto settings = settingsOf(causes_, withNumbers(start_, numbers));
    return seen_[numbers] = ensemble_.halves(settings, effort_.final_runs) - base_;
  }

  double gain(const std::vector<double>& numbers) {
    return Explained(stage_.whitenFit(at(numbers)), stage_.whitenFit(stage_.raw())).gain();
  }

  Halves slope(const FitSpace& space, std::size_t i, const std::vector<double>& numbers) {
    std::vector<double> beside = numbers;
    beside[i] += differenceStep(space, i, numbers[i]);
    return (at(beside) - at(numbers)) * (1 / (beside[i] - numbers[i]));
  }

  // Widens a number's step until its difference is more than chance, up to half the number. Chance
  // fades as a difference widens: one that steepens has gone over a cliff (exact_slopes.cc).
  void widen(FitSpace& space, std::size_t i) {
    if (space.isFixed(i)) return;
    const double most = kWidest * std::abs(space.start[i]);
    double steepness = std::numeric_limits<double>::infinity();
    for (double before = space.step[i];;) {
      const Halves here = stage_.whitenFit(slope(space, i, space.start));
      const double steeper = here.mean().norm();
      if (steeper > steepness) space.step[i] = before;
      if (steeper > steepness || here.coherence() > kCoherent || space.step[i] >= most) return;
      steepness = steeper;
      before = space.step[i];
      space.step[i] =
          std::min(kWider * std::max(space.step[i], 0.05 * std::abs(space.start[i])), most);
    }
  }

 private:
  static constexpr double kCoherent = 0.8, kWidest = 0.5, kWider = 3;

  Ensemble& ensemble_;
  const Stage& stage_;
  const std::vector<Cause>& causes_;
  const CauseList& start_;
  const Effort& effort_;
  Halves base_;
  std::map<std::vector<double>, Halves> seen_;
};

// Of a look, below which a linear cause is better known by the look than by what it does itself:
// that is mostly chance. Free choice.
constexpr double kSmall = 0.4;

// The nearest look at a linear cause that is so much larger; null if there is none. Of a cause
// whose sizes are scanned only the first is linear: at larger ones a joint may meet a stop.
const Look* widerLook(const Stage& stage, const std::vector<Cause>& causes, std::size_t cause,
                      const std::vector<double>& x) {
  const Look* nearest = nullptr;
  if (!causes[cause].linear) return nearest;
  for (const Look& look : stage.looks()) {
    if (look.cause != cause || std::abs(x[0]) > kSmall * std::abs(look.x[0])) continue;
    const FreeNumber& size = causes[cause].free[0];
    if (!causes[cause].scan.empty() && look.x[0] != size.starts.front()) continue;
    if (!std::equal(x.begin() + 1, x.end(), look.x.begin() + 1)) continue;
    if (nearest == nullptr || std::abs(look.x[0]) < std::abs(nearest->x[0])) nearest = &look;
  }
  return nearest;
}

// The model with `cause` as small a part of what it does at the look's size as fits best; the
// model's own numbers follow linearly.
ModelFit fitSmall(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
                  const Look& look, const Effort& effort) {
  ModelFit fit;
  fit.model = stage.model();
  const auto before = settingsOf(causes, fit.model);
  fit.model.push_back({look.cause, look.x});
  const Halves change = ensemble.halves(settingsOf(causes, fit.model), effort.final_runs) -
                        ensemble.halves(before, effort.final_runs);
  const Explained explained(stage.white(change), stage.white(stage.raw()));
  const double scale = std::clamp(explained.bestScale(), look.lower, look.upper);
  fit.model.back().x[0] *= scale;
  fit.change = change * scale;
  fit.gain = explained.gain(scale);
  const Eigen::Index own = stage.jacobian().cols();
  fit.jacobian = stage.jacobian();
  fit.jacobian.conservativeResize(change.first.size(), own + 1);
  fit.chance = Eigen::MatrixXd::Zero(change.first.size(), own + 1);
  setSlope(fit, own, change * (1 / look.x[0]));
  return fit;
}

struct Start {
  QuickFit fit;
  double as_seen = 0;  // [nats] that the look explained, without any scale
};

// Of all looks at its cause: whatever others promise if scaled, this one kept it.
bool isBestSeen(const Start& start, const std::vector<Start>& starts) {
  return start.as_seen > 0 && std::none_of(starts.begin(), starts.end(), [&](const Start& other) {
           return other.fit.cause == start.fit.cause && other.as_seen > start.as_seen;
         });
}

}  // namespace

QuickFit fitQuickly(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
                    const QuickFit& start, const Effort& effort, double least) {
  const auto& [cause, x, promised] = start;
  const auto search = [&, cause = start.cause](SizeSearch::Runs runs) {
    return SizeSearch(ensemble, stage, causes, cause, effort, runs);
  };
  const SizeSearch::Point rough = search(SizeSearch::Runs::Rough).from(x);
  if (rough.gain < least) return {cause, rough.x, rough.gain};
  if (const Look* look = widerLook(stage, causes, cause, x)) {
    const Explained explained(look->white, stage.white(stage.raw()));
    const double gain = explained.gain(x[0] / look->x[0]);
    if (gain > std::max(kKept * promised, rough.gain)) return {cause, x, gain};
  }
  const SizeSearch fine = search(SizeSearch::Runs::Coarse);
  SizeSearch::Point best = fine.near(rough.x);
  if (best.gain < kKept * rough.gain) {  // misled: neighbours matter
    const SizeSearch::Point other = fine.from(x);
    if (other.gain > best.gain) best = other;
  }
  return {cause, best.x, best.gain};
}

QuickFit reshaped(Ensemble& ensemble, const Stage& stage, const std::vector<Cause>& causes,
                  const QuickFit& start, const Effort& effort) {
  if (causes[start.cause].linear || start.x.size() < 2) return start;
  const SizeSearch search(ensemble, stage, causes, start.cause, effort, SizeSearch::Runs::Coarse);
  const SizeSearch::Point best = search.reshaped(start.x);
  return {start.cause, best.x, best.gain};
}

ModelFit fitFully(Ensemble& ensemble, const JointData& data, const Stage& stage,
                  const std::vector<Cause>& causes, const CauseList& start, const Effort& effort,
                  double promised) {
  if (start.size() == stage.model().size() + 1 && start.back().x.size() == 1) {
    const Chosen& added = start.back();
    if (const Look* look = widerLook(stage, causes, added.cause, added.x)) {
      const ModelFit small = fitSmall(ensemble, stage, causes, *look, effort);
      const double ratio = small.model.back().x[0] / added.x[0];
      const bool same = ratio > kAlike && ratio < 1 / kAlike;
      if (same && small.gain > kAsTried * promised) return small;
    }
  }
  FitSpace space;
  for (const Chosen& one : start) append(space, causes[one.cause], one.x);
  ModelChanges changes(ensemble, stage, causes, start, effort);
  for (std::size_t i = 0; i < space.start.size(); ++i) changes.widen(space, i);
  const FitPoint found = leastSquares(
      [&](const std::vector<double>& numbers) -> Eigen::VectorXd {
        return stage.whitenFit(stage.raw() - changes.at(numbers).mean());
      },
      space);
  ModelFit fit;
  std::vector<double> best = found.x;
  fit.gain = changes.gain(best);
  const double before = changes.gain(space.start);
  if (before > fit.gain) fit.gain = before, best = space.start;  // chance is no descent
  fit.model = withNumbers(start, best);
  fit.change = changes.at(best);
  fit.jacobian.resize(data.size(), static_cast<Eigen::Index>(best.size()));
  fit.chance = fit.jacobian;
  for (std::size_t i = 0; i < best.size(); ++i) {
    setSlope(fit, static_cast<Eigen::Index>(i), changes.slope(space, i, best));
  }
  return fit;
}

void setSlope(ModelFit& fit, Eigen::Index column, const Halves& slope) {
  fit.jacobian.col(column) = slope.mean();
  fit.chance.col(column) = (slope.first - slope.second) / 2;
}

SlopeSteps stepsOf(const ModelSlopes& fit, const Stage& stage) {
  std::vector<Eigen::Index> all(static_cast<std::size_t>(fit.jacobian.cols()));
  std::iota(all.begin(), all.end(), Eigen::Index{0});
  return stepsOf(fit, stage, all);
}

SlopeSteps stepsOf(const ModelSlopes& fit, const Stage& stage,
                   const std::vector<Eigen::Index>& columns) {
  const auto whitened = [&](const Eigen::MatrixXd& of) {
    Eigen::MatrixXd white(stage.fitSize(), static_cast<Eigen::Index>(columns.size()));
    for (std::size_t i = 0; i < columns.size(); ++i) {
      white.col(static_cast<Eigen::Index>(i)) = stage.whitenFit(of.col(columns[i]));
    }
    return white;
  };
  return {whitened(fit.jacobian), whitened(fit.chance)};
}

void moveNumbers(ModelFit& fit, const Eigen::VectorXd& raw, const Stage& stage,
                 const std::vector<Cause>& causes) {
  struct Moved {
    double* x;
    const FreeNumber* number;
    Eigen::Index column;
  };
  std::vector<Moved> moved;
  Eigen::Index column = 0;
  for (Chosen& one : fit.model) {
    for (std::size_t i = 0; i < one.x.size(); ++i, ++column) {
      if (i == 0 && causes[one.cause].beats) continue;  // its slope leads nowhere
      moved.push_back({&one.x[i], &causes[one.cause].free[i], column});
    }
  }
  if (moved.empty()) return;
  std::vector<Eigen::Index> columns;
  for (const Moved& one : moved) columns.push_back(one.column);
  const Eigen::VectorXd move = stepsOf(fit, stage, columns)(stage.whitenFit(raw));
  for (std::size_t i = 0; i < moved.size(); ++i) {
    const FreeNumber& number = *moved[i].number;
    double& x = *moved[i].x;
    x = std::clamp(x + move[static_cast<Eigen::Index>(i)], number.lower, number.upper);
  }
}

std::vector<QuickFit> startsFor(const Stage& stage, const std::vector<Cause>& causes,
                                const Eigen::VectorXd& white, double least, int most) {
  std::vector<Start> starts;
  for (const Look& look : stage.looks()) {
    double scale = 0;
    const double gain = Stage::gain(look, white, &scale);
    if (gain < least || scale == 0) continue;
    Start start{{look.cause, look.x, gain}, Explained(look.white, white).gain()};
    // A rough cause is what it was seen to be, if that helped at all; its sizes are scanned later.
    if (causes[look.cause].linear || start.as_seen <= 0) start.fit.x[0] *= scale;
    starts.push_back(std::move(start));
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [](const Start& a, const Start& b) { return a.fit.gain > b.fit.gain; });
  std::vector<QuickFit> kept;
  std::vector<std::size_t> known;
  for (const Start& start : starts) {
    int same = 0;
    double best = 0;
    for (const QuickFit& other : kept) {
      if (other.cause == start.fit.cause) ++same, best = std::max(best, other.gain);
    }
    const bool seen = isBestSeen(start, starts);
    if (!seen && same >= 2) continue;
    if (!seen && same == 1 && start.fit.gain < kNearlyAsGood * best) continue;
    if (same == 0 && static_cast<int>(known.size()) >= most) continue;
    if (same == 0) known.push_back(start.fit.cause);
    kept.push_back(start.fit);
  }
  return kept;
}

}  // namespace nao::validation
