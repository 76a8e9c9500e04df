// Accepted causes seen again: against rivals for their place, and whether they are needed.
#include <algorithm>
#include <limits>
#include <utility>

#include "validation/diagnosis/joint/confusion.h"
#include "validation/diagnosis/joint/exact_slopes.h"
#include "validation/diagnosis/joint/joint_search.h"

namespace nao::validation {
namespace {

constexpr double kSwap = 0.01;  // of the gain: what a rival must be better by
// Of what it explained beside the others: who explains as much beside its successor was no rival.
constexpr double kComesBack = 0.5;
constexpr double kNear = 2;  // [SD of the measured mean] over so short a way slopes hold

// Two directions of one effect, such as x and y of a tilt, or a whole ripple and part of one: no
// rivals, one name.
bool samePlace(const Cause& a, const Cause& b) {
  if (a.id == b.id) return a.alone != b.alone;
  return a.effect == b.effect && a.id.rfind(a.effect + ".", 0) == 0 &&
         b.id.rfind(b.effect + ".", 0) == 0;
}

bool isTooSmall(const Cause& cause, double x) { return std::abs(x) < cause.free[0].smallest; }

}  // namespace

void JointSearch::setRivals(std::size_t place, const std::vector<Candidate>& ranking,
                            const Stage& stage) {
  Accepted& chosen = accepted_[place];
  chosen.rivals.clear();
  chosen.confusion = confusionAmong(ranking, stage);
  const auto own = std::find_if(ranking.begin(), ranking.end(),
                                [&](const Candidate& c) { return c.cause == chosen.cause; });
  if (own == ranking.end()) return;
  for (const Candidate& rival : ranking) {
    if (rival.cause == chosen.cause || isTooSmall(causes_[rival.cause], rival.x[0])) continue;
    if (own->weighed && !rival.weighed) continue;  // was too far off to be weighed
    if (rival.gain < own->gain - reachOf(*own, rival, critical())) continue;
    if (samePlace(causes_[rival.cause], causes_[chosen.cause])) continue;
    chosen.rivals.push_back(rival);
  }
}

Confusion JointSearch::confusionAmong(const std::vector<Candidate>& ranking,
                                      const Stage& stage) const {
  std::vector<Fitted> fitted;
  for (const Candidate& one : ranking) {
    if (one.full) fitted.push_back({causes_[one.cause].id, stage.white(one.fit.change)});
  }
  std::vector<Eigen::VectorXd> nulls;
  for (const Eigen::VectorXd& null : stage.nulls()) nulls.push_back(stage.white(null));
  return confusionOf(fitted, nulls);
}

// Each cause competes again with all others for its place beside the rest of the model.
bool JointSearch::review() {
  bool changed = false;
  // One place after the other: a change puts the new cause last, so that each is seen once.
  std::size_t place = 0;
  for (std::size_t left = accepted_.size(); left > 0 && accepted_.size() > 1; --left) {
    if (ensemble_.spent()) break;
    if (reviewOne(place)) {
      changed = true;
    } else {
      ++place;
    }
  }
  return changed;
}

// The sensitivities of one cause of the model.
Eigen::MatrixXd JointSearch::slopesOf(std::size_t place) const {
  Eigen::Index column = 0;
  for (std::size_t i = 0; i < place; ++i) {
    column += static_cast<Eigen::Index>(fit_.model[i].x.size());
  }
  return fit_.jacobian.middleCols(column, static_cast<Eigen::Index>(fit_.model[place].x.size()));
}

std::unique_ptr<Stage> JointSearch::stageWithout(std::size_t place) const {
  Eigen::MatrixXd jacobian(data_.size(), 0);
  for (std::size_t i = 0; i < fit_.model.size(); ++i) {
    if (i == place) continue;
    const Eigen::MatrixXd slopes = slopesOf(i);
    jacobian.conservativeResize(Eigen::NoChange, jacobian.cols() + slopes.cols());
    jacobian.rightCols(slopes.cols()) = slopes;
  }
  return std::make_unique<Stage>(*stage_, place, jacobian);
}

bool JointSearch::reviewOne(std::size_t place) {
  const auto without = stageWithout(place);
  std::vector<Candidate> ranking = candidates_.rankedAgain(*without, critical(), fit_.model[place]);
  candidates_.weigh(*without, byChance(), ranking);
  const std::size_t cause = accepted_[place].cause;
  const auto own = std::find_if(ranking.begin(), ranking.end(),
                                [&](const Candidate& c) { return c.cause == cause; });
  const double own_gain = own == ranking.end() ? 0 : own->gain;
  const double best_gain = ranking.empty() ? 0 : ranking.front().gain;
  if (std::max(own_gain, best_gain) <= critical()) return goesWithout(place, own_gain, *without);
  if (best_gain > own_gain + std::max(2.0, kSwap * own_gain)) {
    Candidate best = ranking.front();
    if (!best.full) candidates_.fitFinally(*without, best);
    if (best.gain > own_gain + std::max(2.0, kSwap * own_gain)) {
      return swaps(place, own_gain, *without, best, ranking);
    }
  }
  accepted_[place].gain = own_gain;
  setRivals(place, ranking, *without);
  return false;
}

// Drops a cause that nothing misses by its sensitivities, unless exact runs do.
bool JointSearch::goesWithout(std::size_t place, double gain, const Stage& without) {
  if (!entersAsWell(fitFully(ensemble_, data_, without, causes_, without.model(), effort_),
                    accepted_[place].gain)) {
    return false;
  }
  drop(place, gain, "no longer needed beside the others");
  return true;
}

// Enters a model in the place of the one so far, unless exact runs with it leave more: what a cause
// of this gain may.
bool JointSearch::entersAsWell(const ModelFit& fit, double gain) {
  const double before = excess();
  Snapshot whole = snapshot();
  enterModel(fit);
  if (excess() <= before + std::max(2 * critical(), kSwap * gain)) return true;
  restore(std::move(whole));
  return false;
}

// Half the squares that are left, over what null sets leave.
double JointSearch::excess() const {
  return stage_->white(stage_->raw()).squaredNorm() / 2 - byChance().left;
}

void JointSearch::drop(std::size_t place, double gain, const std::string& reason) {
  dropped_[accepted_[place].cause] = std::numeric_limits<double>::infinity();
  reject(accepted_[place].cause, gain, reason);
  accepted_.erase(accepted_.begin() + static_cast<std::ptrdiff_t>(place));
}

// If exact runs refuse the best, coarse ones can not judge this place: all is left as it was.
bool JointSearch::swaps(std::size_t place, double gain, const Stage& without, const Candidate& best,
                        const std::vector<Candidate>& ranking) {
  if (!entersAsWell(best.fit, accepted_[place].gain)) return false;
  Accepted swapped{best.cause,
                   best.gain,
                   accepted_[place].share,
                   crossValidate(data_, without, best.fit, best.x.size()),
                   {},
                   {}};
  const std::size_t cause = accepted_[place].cause;
  drop(place, gain, "explained better by " + causes_[best.cause].id);
  if (gain > critical()) dropped_[cause] = kComesBack * gain;
  accepted_.push_back(swapped);
  setRivals(accepted_.size() - 1, ranking, without);
  return true;
}

// The last numbers, and their intervals, are by exact runs alone.
void JointSearch::refine() {
  left_ = stage_->raw();
  if (fit_.model.empty() || ensemble_.spent()) return;
  fit_.model = stage_->model();  // where its residual was taken
  setExactSlopes(ensemble_, causes_, effort_.slope_runs, *stage_, fit_);
  const Eigen::VectorXd start = columnOf(fit_.model);
  moveNumbers(fit_, stage_->raw(), *stage_, causes_);
  const Eigen::VectorXd change = fit_.jacobian * (columnOf(fit_.model) - start);
  if (stage_->whitenFit(change).norm() < kNear) {
    left_ -= change;
    return;
  }
  const RunPool pool = ensemble_.pool(settingsOf(causes_, fit_.model), effort_.base_runs);
  left_ = data_.mean() - pool.mean;
  const Eigen::VectorXd before = columnOf(fit_.model);
  moveNumbers(fit_, left_, *stage_, causes_);
  left_ -= fit_.jacobian * (columnOf(fit_.model) - before);
}

}  // namespace nao::validation
