#include "validation/diagnosis/joint/pair_fits.h"

#include <algorithm>
#include <array>
#include <utility>

#include "validation/diagnosis/joint/by_chance.h"

namespace nao::validation {
namespace {

// Free choices, by four hidden pairs: the true one was first or second of its kind, and left up to
// twice what the first seemed to leave.
constexpr int kMost = 3;  // pairs of a kind that are fitted
constexpr double kFar = 2.5;
constexpr std::size_t kWeighed = 2;      // by exact runs
constexpr double kRough[] = {0.3, 1.5};  // how far a rough cause is scaled

// How far a cause that was seen with this number may be scaled.
PairPart partOf(const Cause& cause, double x, Eigen::VectorXd white) {
  if (cause.stop || cause.beats) return {std::move(white), 1, 1};
  const double one = cause.free[0].lower / x, other = cause.free[0].upper / x;
  const double lower = std::min(one, other), upper = std::max(one, other);
  if (cause.linear) return {std::move(white), lower, upper};
  return {std::move(white), std::max(lower, kRough[0]), std::min(upper, kRough[1])};
}

Chosen scaled(Chosen one, double scale) {
  one.x[0] *= scale;
  return one;
}

bool actsOnCommand(const Cause& cause) {
  const sim::EffectType* type = sim::standardEffects().find(cause.effect);
  return type != nullptr && includes(type->acts, sim::Acts::OnCommand);
}

double half(const Eigen::VectorXd& x) { return x.squaredNorm() / 2; }

bool hasAny(const CauseList& model, const CauseList& of) {
  return std::any_of(of.begin(), of.end(),
                     [&](const Chosen& one) { return has(model, one.cause); });
}

bool hasSame(const CauseList& model, const CauseList& of) {
  return model.size() == of.size() && std::all_of(of.begin(), of.end(), [&](const Chosen& one) {
           return has(model, one.cause);
         });
}

CauseList turned(CauseList model) {
  std::reverse(model.begin(), model.end());
  return model;
}

// What explained something alone, at its best, and what was found.
CauseList withFound(const CauseList& firsts, const CauseList& found) {
  CauseList parts = found;
  for (const Chosen& one : firsts) {
    if (!has(parts, one.cause)) parts.push_back(one);
  }
  return parts;
}

}  // namespace

bool isOrderly(const std::vector<Cause>& causes, const CauseList& model) {
  return std::all_of(model.begin(), model.end(),
                     [&](const Chosen& one) { return actsOnCommand(causes[one.cause]); });
}

PairFits::PairFits(Ensemble& ensemble, const JointData& data, const std::vector<Cause>& causes,
                   const Effort& effort, const Stage& start, const Stage& now)
    : ensemble_(ensemble),
      data_(data),
      causes_(causes),
      effort_(effort),
      start_(start),
      now_(now) {}

// What each part does alone.
std::vector<PairPart> PairFits::seenAlone(const CauseList& parts) {
  std::vector<PairPart> seen;
  for (const Chosen& one : parts) {
    const Halves change =
        ensemble_.roughHalves(settingsOf(causes_, {one}), effort_.look_runs, Over::Fit) -
        start_.lookBase();
    seen.push_back(partOf(causes_[one.cause], one.x[0], start_.white(change).mean()));
  }
  return seen;
}

// What was seen of each alone favours what was found: as many others have none of that. Of two that
// alter the command each may act first.
std::vector<CauseList> PairFits::worthAFit(const CauseList& firsts, const CauseList& found) {
  const CauseList parts = withFound(firsts, found);
  std::vector<CauseList> models;
  if (found.size() == 2 && isOrderly(causes_, found)) models.push_back(turned(found));
  std::array<int, 2> count{};  // of those without and with what was found
  std::array<double, 2> least{};
  for (const PartPair& pair : pairsOf(seenAlone(parts), start_.white(start_.raw()))) {
    const CauseList model = {scaled(parts[pair.first], pair.first_scale),
                             scaled(parts[pair.second], pair.second_scale)};
    if (hasSame(found, model)) continue;
    const std::size_t kind = hasAny(found, model) ? 1 : 0;
    if (count[kind] == 0) least[kind] = pair.left;
    if (count[kind] >= kMost || pair.left > kFar * least[kind]) continue;
    ++count[kind];
    models.push_back(model);
    if (isOrderly(causes_, model)) models.push_back(turned(model));
  }
  return models;
}

// Best first; none after one that leaves no more than chance. Their numbers go on by exact runs.
std::vector<ModelFit> PairFits::fitted(const std::vector<CauseList>& pairs) {
  const double all = half(start_.white(start_.raw())), most_left = chanceOf(now_, 0).most_left;
  Effort brief = effort_;
  brief.final_runs = effort_.look_runs;
  std::vector<ModelFit> fits;
  for (const CauseList& pair : pairs) {
    if (ensemble_.spent()) break;
    fits.push_back(fitFully(ensemble_, data_, start_, causes_, pair, brief));
    if (all - fits.back().gain <= most_left) break;
  }
  std::stable_sort(fits.begin(), fits.end(),
                   [](const ModelFit& a, const ModelFit& b) { return a.gain > b.gain; });
  return fits;
}

// Half the squares that exact runs leave, the numbers moved to where that is least.
double PairFits::leftBy(ModelFit& fit) {
  const auto left = [&](int runs) -> Eigen::VectorXd {
    return data_.mean() - ensemble_.pool(settingsOf(causes_, fit.model), runs).mean;
  };
  moveNumbers(fit, left(effort_.brief_runs), start_, causes_);
  return half(now_.whitenFit(left(effort_.slope_runs)));
}

std::optional<ModelFit> PairFits::best(const CauseList& firsts, const CauseList& found) {
  std::vector<ModelFit> fits = fitted(worthAFit(firsts, found));
  fits.resize(std::min(fits.size(), kWeighed));
  std::optional<ModelFit> best;
  double least = 0;
  for (ModelFit& fit : fits) {
    const double left = leftBy(fit);
    if (best && left >= least) continue;
    best = fit;
    least = left;
  }
  return best;
}

}  // namespace nao::validation
