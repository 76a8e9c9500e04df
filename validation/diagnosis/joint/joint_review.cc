// FoundCause causes seen again: against rivals for their place, and whether they are needed.
#include <algorithm>
#include <limits>
#include <utility>

#include "validation/diagnosis/joint/confusion.h"
#include "validation/diagnosis/joint/joint_search.h"

namespace nao::validation {
namespace {

constexpr double kSwap = 0.01;  // of the gain: what a rival must be better by
// Of what it explained beside the others: who explains as much beside its successor was no rival.
constexpr double kComesBack = 0.5;

// Two directions of one effect, such as x and y of a tilt, or a whole ripple and part of one: no
// rivals, one name.
bool samePlace(const Cause& a, const Cause& b) {
  if (a.id == b.id) return a.alone != b.alone;
  return a.effect == b.effect && a.id.rfind(a.effect + ".", 0) == 0 &&
         b.id.rfind(b.effect + ".", 0) == 0;
}

bool isTooSmall(const Cause& cause, double x) { return std::abs(x) < cause.free[0].smallest; }

Confusion confusionAmong(const std::vector<Candidate>& ranking, const Stage& stage,
                         const std::vector<Cause>& causes) {
  std::vector<Fitted> fitted;
  for (const Candidate& one : ranking) {
    if (one.full) fitted.push_back({causes[one.cause].id, stage.white(one.fit.change)});
  }
  std::vector<Eigen::VectorXd> nulls;
  for (const Eigen::VectorXd& null : stage.nulls()) nulls.push_back(stage.white(null));
  return confusionOf(fitted, nulls);
}

}  // namespace

void JointSearch::setRivals(std::size_t place, const std::vector<Candidate>& ranking,
                            const Stage& stage) {
  FoundCause& chosen = model_.found()[place];
  chosen.rivals.clear();
  chosen.confusion = confusionAmong(ranking, stage, causes_);
  const auto own = std::find_if(ranking.begin(), ranking.end(),
                                [&](const Candidate& c) { return c.cause == chosen.cause; });
  if (own == ranking.end()) return;
  for (const Candidate& rival : ranking) {
    if (rival.cause == chosen.cause || isTooSmall(causes_[rival.cause], rival.x[0])) continue;
    if (own->weighed && !rival.weighed) continue;  // was too far off to be weighed
    if (rival.gain < own->gain - reachOf(*own, rival, model_.critical())) continue;
    if (samePlace(causes_[rival.cause], causes_[chosen.cause])) continue;
    chosen.rivals.push_back(rival);
  }
}

// Each cause competes again with all others for its place beside the rest of the model.
bool JointSearch::review() {
  bool changed = false;
  // One place after the other: a change puts the new cause last, so that each is seen once.
  std::size_t place = 0;
  for (std::size_t left = model_.found().size(); left > 0 && model_.found().size() > 1; --left) {
    if (ensemble_.spent()) break;
    if (reviewOne(place)) {
      changed = true;
    } else {
      ++place;
    }
  }
  return changed;
}

// The same of one that is alone, too.
void JointSearch::reviewAll() {
  std::size_t place = 0;
  for (std::size_t left = model_.found().size(); left > 0 && !ensemble_.spent(); --left) {
    if (!reviewOne(place)) ++place;
  }
}

bool JointSearch::reviewOne(std::size_t place) {
  const auto without = model_.stageWithout(place);
  std::vector<Candidate> ranking =
      candidates_.rankedAgain(*without, model_.critical(), model_.fit().model[place]);
  candidates_.weigh(*without, model_.byChance(), ranking);
  const std::size_t cause = model_.found()[place].cause;
  const auto own = std::find_if(ranking.begin(), ranking.end(),
                                [&](const Candidate& c) { return c.cause == cause; });
  const double own_gain = own == ranking.end() ? 0 : own->gain;
  const double best_gain = ranking.empty() ? 0 : ranking.front().gain;
  if (std::max(own_gain, best_gain) <= model_.critical())
    return goesWithout(place, own_gain, *without);
  if (best_gain > own_gain + std::max(2.0, kSwap * own_gain)) {
    Candidate best = ranking.front();
    if (!best.full) candidates_.fitFinally(*without, best);
    if (best.gain > own_gain + std::max(2.0, kSwap * own_gain)) {
      return swaps(place, own_gain, *without, best, ranking);
    }
  }
  model_.found()[place].gain = own_gain;
  setRivals(place, ranking, *without);
  return false;
}

// Drops a cause that nothing misses by its sensitivities, unless exact runs do.
bool JointSearch::goesWithout(std::size_t place, double gain, const Stage& without) {
  if (!entersAsWell(fitFully(ensemble_, data_, without, causes_, without.model(), effort_),
                    model_.found()[place].gain)) {
    return false;
  }
  drop(place, gain, "no longer needed beside the others");
  return true;
}

// Enters a model in the place of the one so far, unless exact runs with it leave more: what a cause
// of this gain may.
bool JointSearch::entersAsWell(const ModelFit& fit, double gain) {
  const double before = model_.excess();
  JointModel::Snapshot whole = model_.snapshot();
  model_.enter(fit);
  if (model_.excess() <= before + std::max(2 * model_.critical(), kSwap * gain)) return true;
  model_.restore(std::move(whole));
  return false;
}

void JointSearch::drop(std::size_t place, double gain, const std::string& reason) {
  dropped_[model_.found()[place].cause] = std::numeric_limits<double>::infinity();
  reject(model_.found()[place].cause, gain, reason);
  model_.found().erase(model_.found().begin() + static_cast<std::ptrdiff_t>(place));
}

// If exact runs refuse the best, coarse ones can not judge this place: all is left as it was.
bool JointSearch::swaps(std::size_t place, double gain, const Stage& without, const Candidate& best,
                        const std::vector<Candidate>& ranking) {
  if (!entersAsWell(best.fit, model_.found()[place].gain)) return false;
  FoundCause swapped{best.cause,
                     best.gain,
                     model_.found()[place].share,
                     crossValidate(data_, without, best.fit, best.x.size()),
                     {},
                     {}};
  const std::size_t cause = model_.found()[place].cause;
  drop(place, gain, "explained better by " + causes_[best.cause].id);
  if (gain > model_.critical()) dropped_[cause] = kComesBack * gain;
  model_.found().push_back(swapped);
  setRivals(model_.found().size() - 1, ranking, without);
  return true;
}

}  // namespace nao::validation
